#include "core/world/world.hpp"

#include "core/contact/rollingResistance.hpp"
#include "core/dynamics/mostTravel.hpp"
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
constexpr double skinShare = 0.2;

template <class Predicate>
bool anyLaw(const ContactLaws& laws, Predicate predicate)
{
    return std::visit([&](const auto& table) { return table.any(predicate); }, laws);
}

bool isFrictional(const ContactLaws& laws)
{
    return anyLaw(laws, [](const auto& law) { return law.frictional(); });
}

bool useCurvature(const ContactLaws& laws)
{
    return anyLaw(laws, [](const auto& law) { return std::decay_t<decltype(law)>::usesCurvature; });
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
    case StepStatus::tooNarrow:
        return "the periodic cell has become narrower than two of its biggest grains reach";
    case StepStatus::badTimeStep:
        return "the time step is no positive finite number";
    }
    return "";
}

World::World(WorldSettings settings)
: settings_(std::move(settings)),
  cell_(settings_.cell),
  list_(isFrictional(settings_.contact), resistsRolling(settings_.contact), useCurvature(settings_.contact)),
  walls_(settings_.walls)
{
    for (const NamedShape& named : settings_.shapes)
    {
        masses_.push_back(massProperties(named.shape));
        straightSided_.push_back(hasStraightSides(named.shape));
        onlyDisks_ = onlyDisks_ && std::holds_alternative<Circle>(named.shape);
        stiffness_.push_back(largestStiffness(boundingRadius(named.shape)));
        innerRadii_.push_back(innerRadius(named.shape));
    }
    const std::vector<GrainState> grains = std::move(settings_.grains);
    settings_.grains = {};
    bodies_.reserve(grains.size());
    for (const GrainState& grain : grains)
    {
        addBody(grain);
    }
    brakingRate_ = brakingRate();
    const std::vector<double>& radii = bodies_.boundingRadius;
    if (!radii.empty())
    {
        const auto [least, most] = std::minmax_element(radii.begin(), radii.end());
        const double leastInner = *std::min_element(innerRadii_.begin(), innerRadii_.end());
        skin_ = std::min(skinShare * *least, mostTravel(leastInner));
        shallow_ = mostDepth(leastInner, 2 * mostTravel(leastInner));
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

/// z sqrt(k/m) of two like grains, the fastest of all.
double World::brakingRate() const
{
    const double dampingRatio = std::visit(
        [](const auto& table)
        {
            double largest = 0;
            for (const auto& law : table.all())
            {
                largest = std::max(largest, law.dampingRatio);
            }
            return largest;
        },
        settings_.contact);
    double fastest = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        fastest = std::max(fastest, stiffness_[static_cast<std::size_t>(bodies_.shape[i])] * 2 * bodies_.inverseMass[i]);
    }
    return dampingRatio * std::sqrt(fastest);
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
