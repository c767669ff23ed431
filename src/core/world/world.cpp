#include "core/world/world.hpp"

#include "core/contact/rollingResistance.hpp"
#include "core/dynamics/stableTimeStep.hpp"
#include "core/dynamics/velocityVerlet.hpp"
#include "core/measure/energy.hpp"
#include "core/measure/stress.hpp"
#include "core/world/flatContact.hpp"

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
    }
    return "";
}

World::World(WorldSettings settings)
: settings_(std::move(settings)),
  cell_(settings_.cell),
  list_(isFrictional(settings_.contact), resistsRolling(settings_.contact)),
  walls_(settings_.walls)
{
    for (const NamedShape& named : settings_.shapes)
    {
        masses_.push_back(massProperties(named.shape));
        straightSided_.push_back(hasStraightSides(named.shape));
        stiffness_.push_back(largestStiffness(boundingRadius(named.shape)));
    }
    const std::vector<GrainState> grains = std::move(settings_.grains);
    settings_.grains = {};
    bodies_.reserve(grains.size());
    for (const GrainState& grain : grains)
    {
        addBody(grain);
    }
    const std::vector<double>& radii = bodies_.boundingRadius;
    if (!radii.empty())
    {
        const auto [least, most] = std::minmax_element(radii.begin(), radii.end());
        skin_ = skinShare * *least;
        largestReach_ = 2 * *most + skin_;
    }
}

void World::addBody(const GrainState& grain)
{
    const auto shape = static_cast<std::size_t>(grain.shape);
    const double density = settings_.materials[static_cast<std::size_t>(grain.material)].density;
    bodies_.pose.push_back({grain.position, Rotation<2>(grain.angle)});
    bodies_.velocity.push_back(cell_ ? Vector2(grain.velocity + cell_->flow(grain.position)) : grain.velocity);
    bodies_.angularVelocity.push_back(grain.angularVelocity);
    bodies_.force.emplace_back(Vector2::Zero());
    bodies_.torque.push_back(0);
    bodies_.inverseMass.push_back(grain.driven ? 0 : 1 / (density * masses_[shape].area));
    bodies_.inverseInertia.push_back(grain.driven ? 0 : 1 / (density * masses_[shape].polarMoment));
    bodies_.shape.push_back(grain.shape);
    bodies_.boundingRadius.push_back(boundingRadius(settings_.shapes[shape].shape));
    if (settings_.materials.size() > 1)
    {
        materialOf_.push_back(grain.material);
    }
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
    fluidDensity_ = fluidDensity;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (bodies_.inverseMass[i] > 0)
        {
            const double density = densityOf(i) + virtualMass * fluidDensity;
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
    if (cell_ && cell_->isStrained())
    {
        cell_->strain(timeStep);
        noteStrain();
    }
    if (walls_.anyMoves())
    {
        walls_.setVelocities(time_, timeStep);
        walls_.addWork(timeStep / 2);
        walls_.drift(timeStep);
    }
    const bool stale = cell_ ? moveGrains<true>(timeStep) : moveGrains<false>(timeStep);
    if (ledger_)
    {
        addWorks(timeStep);
    }
    updateForces(timeStep, stale);
    const StepStatus status = finishMoves(timeStep);
    if (walls_.anyMoves())
    {
        walls_.addWork(timeStep / 2);
        if (ledger_)
        {
            ledger_->walls = walls_.work();
        }
    }
    time_ += timeStep;
    return status;
}

void World::noteStrain()
{
    strainSinceSearch_ = cell_->deformationFrom(firstAtSearch_, secondAtSearch_) - Eigen::Matrix2d::Identity();
}

/// Half a kick, then the drift; true if a grain has moved too far for its neighbours to be still all that are near.
template <bool periodic>
bool World::moveGrains(double timeStep)
{
    const double most = mostMovement();
    bool stale = positionsAtSearch_.size() != bodies_.size() || !(most > 0);
    const std::size_t known = stale ? 0 : bodies_.size();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        kick(bodies_, i, timeStep / 2);
        drift(bodies_, i, timeStep);
        stale |= i < known && hasLeft<periodic>(i, most);
    }
    return stale;
}

/// The other half of the kick, and whether all went well.
StepStatus World::finishMoves(double timeStep)
{
    // Stays zero if all numbers are finite.
    double sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        kick(bodies_, i, timeStep / 2);
        sum += 0 * bodies_.velocity[i].x() + 0 * bodies_.velocity[i].y() + 0 * bodies_.angularVelocity[i];
    }
    if (tooDeep_)
    {
        return StepStatus::tooDeep;
    }
    return sum == 0 && !lost_ ? StepStatus::done : brokenState();
}

StepStatus World::brokenState()
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

void World::addWorks(double timeStep)
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (bodies_.inverseMass[i] > 0)
        {
            ledger_->gravity += timeStep * weightOf(i).dot(bodies_.velocity[i]);
            if (!externalForces_.empty())
            {
                ledger_->external +=
                    timeStep * (externalForces_[i].dot(bodies_.velocity[i]) + externalTorques_[i] * bodies_.angularVelocity[i]);
            }
        }
    }
}

void World::setVelocityGradient(const Eigen::Matrix2d& gradient)
{
    const Eigen::Matrix2d change = gradient - cell_->velocityGradient;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        bodies_.velocity[i] += change * (bodies_.pose[i].position - cell_->cell.lower());
    }
    cell_->velocityGradient = gradient;
}

Vector2 World::branchOf(const Contact<2>& contact) const
{
    return cell_ ? Vector2(branchVector(contact, bodies_) + offsetOf(contact)) : branchVector(contact, bodies_);
}

/// Of a grain since the last search, on top of the cell's strain, so that no pair that was farther apart than the skin
/// can touch [m]. Images at the reach of the widest pair come nearer by the strain itself.
double World::mostMovement() const
{
    double most = skin_ / 2;
    if (walls_.anyMoves() && !(walls_.movedSinceSearch() <= most))
    {
        return 0;
    }
    if (cell_)
    {
        most -= strainSinceSearch_.norm() * largestReach_ / 2;
    }
    return most;
}

/// Written so that a position that is not a number asks for a search, too.
template <bool periodic>
bool World::hasLeft(std::size_t grain, double most) const
{
    const Vector2& old = positionsAtSearch_[grain];
    Vector2 moved = bodies_.pose[grain].position - old;
    if constexpr (periodic)
    {
        moved -= strainSinceSearch_ * (old - cell_->cell.lower());
    }
    return !(moved.squaredNorm() <= most * most);
}

bool World::neighboursAreStale() const
{
    const double most = mostMovement();
    if (positionsAtSearch_.size() != bodies_.size() || !(most > 0))
    {
        return true;
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (cell_ ? hasLeft<true>(i, most) : hasLeft<false>(i, most))
        {
            return true;
        }
    }
    return false;
}

void World::findNeighbours()
{
    if (cell_)
    {
        wrapGrains();
        firstAtSearch_ = cell_->cell.first();
        secondAtSearch_ = cell_->cell.second();
        strainSinceSearch_.setZero();
    }
    positionsAtSearch_.resize(bodies_.size());
    std::transform(
        bodies_.pose.begin(), bodies_.pose.end(), positionsAtSearch_.begin(), [](const Pose<2>& p) { return p.position; });
    walls_.noteSearch();
    findContacts();
    lost_ = brokenState() != StepStatus::done;
}

/// Grains that have left the cell come in from the other side, with the flow's velocity there; the ledger counts the
/// difference as work of the boundary.
void World::wrapGrains()
{
    cell_->straighten();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        const Shift shift = cell_->cell.wrap(bodies_.pose[i].position);
        if (shift == Shift{})
        {
            continue;
        }
        const Vector2 jump = cell_->velocityGradient * cell_->cell.offset(shift);
        if (ledger_ && bodies_.inverseMass[i] > 0)
        {
            ledger_->walls += jump.dot(bodies_.velocity[i] + jump / 2) / bodies_.inverseMass[i];
        }
        bodies_.velocity[i] += jump;
    }
}

void World::findContacts()
{
    const std::vector<Vector2> noBoxes;
    const std::vector<NeighbourPair>& pairs = cell_
        ? search_.find(positionsAtSearch_, noBoxes, bodies_.boundingRadius, skin_, cell_->cell)
        : search_.find(positionsAtSearch_, noBoxes, bodies_.boundingRadius, skin_);
    list_.restart(pairs.size());
    for (const auto& [first, second, shift] : pairs)
    {
        const bool flat = isStraightSided(static_cast<std::size_t>(first)) && isStraightSided(static_cast<std::size_t>(second));
        list_.add(first, second, flat, shift);
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
