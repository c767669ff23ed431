#include "core/world/world.hpp"

#include "core/contact/rollingResistance.hpp"
#include "core/dynamics/mostTravel.hpp"
#include "core/dynamics/stableTimeStep.hpp"
#include "core/dynamics/velocityVerlet.hpp"
#include "core/measure/energy.hpp"
#include "core/world/flatContact.hpp"
#include "core/world/inscribedRadius.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

/// Share of the smallest grain's radius that grains may move before neighbours are searched again: the optimum
/// between long lists and frequent searches is flat around it.
constexpr double skinShare = 0.3;

template <class Predicate>
bool anyLaw(const ContactLaws& laws, Predicate predicate)
{
    return std::visit([&](const auto& table) { return table.any(predicate); }, laws);
}

bool isFrictional(const ContactLaws& laws)
{
    return anyLaw(laws, [](const auto& law) { return law.frictional(); });
}

bool resistsRolling(const ContactLaws& laws)
{
    return anyLaw(laws, [](const auto& law) { return law.rollingFriction > 0; });
}

} // namespace

std::string describe(StepStatus status, std::size_t brokenGrain)
{
    const std::string grain = "grain " + std::to_string(brokenGrain);
    switch (status)
    {
    case StepStatus::done:
        return "done";
    case StepStatus::notFinite:
        return "the state of " + grain + " is no finite number";
    case StepStatus::tooDeep:
        return "a contact of " + grain + " is deeper than its law and the time step hold for";
    case StepStatus::tooFast:
        return grain + " is so fast that in one step it could leap over another; a smaller time step is needed";
    }
    return "";
}

World::World(WorldSettings settings)
: settings_(std::move(settings)), list_(isFrictional(settings_.contact), resistsRolling(settings_.contact)), walls_(settings_.walls)
{
    for (const NamedShape& named : settings_.shapes)
    {
        masses_.push_back(massProperties(named.shape));
        inscribedRadii_.push_back(inscribedRadius(named.shape));
        straightSided_.push_back(hasStraightSides(named.shape));
        stiffness_.push_back(largestStiffness(boundingRadius(named.shape)));
    }
    double smallest = std::numeric_limits<double>::infinity();
    for (const GrainState& grain : settings_.grains)
    {
        const auto shape = static_cast<std::size_t>(grain.shape);
        const double radius = boundingRadius(settings_.shapes[shape].shape);
        const double density = settings_.materials[static_cast<std::size_t>(grain.material)].density;
        const double mass = density * masses_[shape].area;
        const double inertia = density * masses_[shape].polarMoment;
        bodies_.pose.push_back({grain.position, Rotation<2>(grain.angle)});
        bodies_.velocity.push_back(grain.velocity);
        bodies_.angularVelocity.push_back(grain.angularVelocity);
        bodies_.inverseMass.push_back(grain.driven ? 0 : 1 / mass);
        bodies_.inverseInertia.push_back(grain.driven ? 0 : 1 / inertia);
        bodies_.shape.push_back(grain.shape);
        bodies_.boundingRadius.push_back(radius);
        halfExtents_.emplace_back(radius, radius);
        weights_.push_back(mass * settings_.gravity);
        smallest = std::min(smallest, radius);
    }
    bodies_.force.assign(bodies_.size(), Vector2::Zero());
    bodies_.torque.assign(bodies_.size(), 0.0);
    skin_ = bodies_.size() > 0 ? skinShare * smallest : 0;
}

double World::largestStiffness(double radius) const
{
    return std::visit(
        [radius](const auto& table)
        {
            double largest = 0;
            for (const auto& law : table.all())
            {
                largest = std::max(largest, law.largestStiffness(radius));
            }
            return largest;
        },
        settings_.contact);
}

void World::immerse(double fluidDensity, double virtualMass)
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        const double ownDensity = settings_.materials[materialOf(i)].density;
        weights_[i] = (ownDensity - fluidDensity) * areaOf(i) * settings_.gravity;
        if (bodies_.inverseMass[i] > 0)
        {
            const double density = ownDensity + virtualMass * fluidDensity;
            bodies_.inverseMass[i] = 1 / (density * areaOf(i));
            bodies_.inverseInertia[i] = 1 / (density * polarMomentOf(i));
        }
    }
}

void World::setExternalLoads(const std::vector<Vector2>& forces, const std::vector<double>& torques)
{
    externalForces_ = forces;
    externalTorques_ = torques;
}

double World::sizeOf(std::size_t grain) const
{
    return 2 * std::sqrt(areaOf(grain) / M_PI);
}

double World::stableTimeStep() const
{
    double dampingRatio = 0;
    double rollingFriction = 0;
    std::visit(
        [&](const auto& table)
        {
            for (const auto& law : table.all())
            {
                dampingRatio = std::max(dampingRatio, law.dampingRatio);
                rollingFriction = std::max(rollingFriction, law.rollingFriction);
            }
        },
        settings_.contact);
    StableTimeStep step;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (bodies_.inverseMass[i] > 0)
        {
            const int places = isStraightSided(i) ? 2 : 1;
            const double stiffness = stiffness_[static_cast<std::size_t>(bodies_.shape[i])];
            step.add(
                1 / bodies_.inverseMass[i], 1 / bodies_.inverseInertia[i], bodies_.boundingRadius[i], stiffness, places,
                rollingStiffness * rollingFriction * rollingFriction);
        }
    }
    return step.of(dampingRatio, settings_.localDamping);
}

StepStatus World::step(double timeStep)
{
    if (settings_.energyLedger && !ledger_)
    {
        ledger_.emplace();
        ledger_->start = kineticEnergy(bodies_) + contactEnergy();
    }
    kick(bodies_, timeStep / 2);
    if (leaps(timeStep))
    {
        return StepStatus::tooFast;
    }
    drift(bodies_, timeStep);
    if (walls_.anyMoves())
    {
        walls_.setVelocities(time_, timeStep);
        walls_.addWork(timeStep / 2);
        walls_.drift(timeStep);
    }
    if (ledger_)
    {
        addWorks(timeStep);
    }
    updateForces(timeStep);
    kick(bodies_, timeStep / 2);
    if (walls_.anyMoves())
    {
        walls_.addWork(timeStep / 2);
        if (ledger_)
        {
            ledger_->walls = walls_.work();
        }
    }
    time_ += timeStep;
    return tooDeep_ || sinksThrough() ? StepStatus::tooDeep : checkFinite();
}

void World::addWorks(double timeStep)
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (bodies_.inverseMass[i] > 0)
        {
            ledger_->gravity += timeStep * weights_[i].dot(bodies_.velocity[i]);
            if (!externalForces_.empty())
            {
                ledger_->external +=
                    timeStep * (externalForces_[i].dot(bodies_.velocity[i]) + externalTorques_[i] * bodies_.angularVelocity[i]);
            }
        }
    }
}

bool World::neighboursAreStale() const
{
    if (positionsAtSearch_.size() != bodies_.size())
    {
        return true;
    }
    const double most = skin_ / 2;
    if (walls_.anyMoves() && !(walls_.movedSinceSearch() <= most))
    {
        return true;
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        // Written so that a position that is not a number asks for a search, too.
        if (!((bodies_.pose[i].position - positionsAtSearch_[i]).squaredNorm() <= most * most))
        {
            return true;
        }
    }
    return false;
}

void World::updateNeighbours()
{
    if (bodies_.size() > 0 && neighboursAreStale())
    {
        positionsAtSearch_.resize(bodies_.size());
        std::transform(
            bodies_.pose.begin(), bodies_.pose.end(), positionsAtSearch_.begin(), [](const Pose<2>& p) { return p.position; });
        walls_.noteSearch();
        findContacts();
    }
}

void World::findContacts()
{
    list_.restart();
    for (const auto& [first, second] : search_.find(positionsAtSearch_, halfExtents_, bodies_.boundingRadius, skin_))
    {
        const bool flat = isStraightSided(static_cast<std::size_t>(first)) && isStraightSided(static_cast<std::size_t>(second));
        list_.add(first, second, flat);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        for (std::size_t w = walls_.walls().size(); w-- > 0;)
        {
            if (walls()[w].distance(positionsAtSearch_[i]) <= bodies_.boundingRadius[i] + skin_)
            {
                list_.add(static_cast<std::int32_t>(i), Contact<2>::wallAsSecond(w), isStraightSided(i));
            }
        }
    }
    list_.carryOver();
}

bool World::leaps(double timeStep)
{
    for (std::size_t i = 0; i < bodies_.size() && bodies_.size() > 1; ++i)
    {
        // What is no number goes on to checkFinite.
        const double way = travel(bodies_.velocity[i], bodies_.angularVelocity[i], bodies_.boundingRadius[i], timeStep);
        if (way > mostTravel(inscribedRadiusOf(i)) && std::isfinite(way))
        {
            brokenGrain_ = i;
            return true;
        }
    }
    return false;
}

bool World::sinksThrough()
{
    for (const Contact<2>& contact : contacts())
    {
        if (contact.withWall())
        {
            continue;
        }
        const auto i = static_cast<std::size_t>(contact.first);
        if (contact.depth > mostDepth(inscribedRadiusOf(i), inscribedRadiusOf(static_cast<std::size_t>(contact.second))))
        {
            brokenGrain_ = i;
            return true;
        }
    }
    return false;
}

StepStatus World::checkFinite()
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (!bodies_.velocity[i].allFinite() || !std::isfinite(bodies_.angularVelocity[i])
            || !bodies_.pose[i].position.allFinite())
        {
            brokenGrain_ = i;
            return StepStatus::notFinite;
        }
    }
    return StepStatus::done;
}

double World::largestRelativeOverlap() const
{
    double largest = 0;
    for (const Contact<2>& contact : contacts())
    {
        double size = sizeOf(static_cast<std::size_t>(contact.first));
        if (!contact.withWall())
        {
            size = std::min(size, sizeOf(static_cast<std::size_t>(contact.second)));
        }
        largest = std::max(largest, contact.depth / size);
    }
    return largest;
}

} // namespace chesil
