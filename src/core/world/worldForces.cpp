#include "core/world/world.hpp"

#include "core/contact/contactForce.hpp"
#include "core/contact/rollingResistance.hpp"
#include "core/dynamics/localDamping.hpp"
#include "core/dynamics/mostTravel.hpp"
#include "core/dynamics/viscousDamping.hpp"
#include "core/measure/energy.hpp"
#include "core/world/diskContact.hpp"
#include "core/world/flatContact.hpp"
#include "core/world/pairContact.hpp"
#include "core/world/wallContact.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

void World::updateForces()
{
    anticipates_ = false;
    updateForces(0, neighboursAreStale());
}

void World::updateForces(double timeStep, bool stale)
{
    if (stale && bodies_.size() > 0)
    {
        findNeighbours();
    }
    applyWeights();
    walls_.clearForces();
    const auto resolveWith = [&](const auto& laws)
    { cell_ ? resolveAll<true>(laws, timeStep) : resolveAll<false>(laws, timeStep); };
    std::visit(resolveWith, settings_.contact);
    const auto flow = [this](std::size_t i) { return cell_ ? cell_->flow(bodies_.pose[i].position) : Vector2(Vector2::Zero()); };
    if (settings_.viscousDamping > 0)
    {
        withLoss(&EnergyLedger::viscousDamping, timeStep, [&] { dampViscously(bodies_, settings_.viscousDamping, flow); });
    }
    if (settings_.localDamping > 0)
    {
        withLoss(&EnergyLedger::localDamping, timeStep, [&] { dampLocally(bodies_, settings_.localDamping, flow); });
    }
}

template <class Damping>
void World::withLoss(double EnergyLedger::*loss, double timeStep, const Damping& damp)
{
    if (!ledger_)
    {
        damp();
        return;
    }
    const double before = powerOfForces(bodies_);
    damp();
    (*ledger_).*loss += timeStep * (before - powerOfForces(bodies_));
}

Vector2 World::weightOf(std::size_t grain) const
{
    return (densityOf(grain) - fluidDensity_) * areaOf(grain) * settings_.gravity;
}

void World::applyWeights()
{
    const bool weightless = settings_.gravity == Vector2::Zero();
    const bool loaded = !externalForces_.empty();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        bodies_.force[i] = weightless ? Vector2(Vector2::Zero()) : weightOf(i);
        bodies_.torque[i] = 0;
        if (loaded)
        {
            bodies_.force[i] += externalForces_[i];
            bodies_.torque[i] = externalTorques_[i];
        }
    }
}

template <bool periodic, class Law>
void World::resolveAll(const LawTable<Law>& laws, double timeStep)
{
    const std::size_t entries = list_.contacts().size();
    for (std::size_t i = 0; i < entries; i += list_.placesOf(i))
    {
        resolve<periodic>(laws, i, timeStep);
    }
}

template <class Law>
const Law& World::lawOf(const LawTable<Law>& laws, const Contact<2>& contact) const
{
    if (laws.materials() == 1)
    {
        return laws.of(0, 0);
    }
    const std::size_t other = contact.withWall() ? static_cast<std::size_t>(walls()[contact.wall()].material)
                                                 : materialOf(static_cast<std::size_t>(contact.second));
    return laws.of(materialOf(static_cast<std::size_t>(contact.first)), other);
}

template <bool periodic, class Law>
void World::resolve(const LawTable<Law>& laws, std::size_t index, double timeStep)
{
    Contact<2>& contact = list_.contacts()[index];
    Contact<2>* second = list_.placesOf(index) == 2 ? &contact + 1 : nullptr;
    const Law& law = lawOf(laws, contact);
    ContactGeometry<2> found;
    if (!(contact.withWall() ? touchesWall(contact, found) : touchesGrain<periodic>(contact, found)))
    {
        release(law, index);
        if (second)
        {
            release(law, index + 1);
        }
        return;
    }
    contact.normal = found.normal;
    std::array<ContactGeometry<2>, 2> places;
    if (second && areFlat<periodic>(contact, found, places))
    {
        // The one corner of a tilted side is the same contact, whichever end of the other shape it is.
        const bool first = contact.depth > 0;
        double* spring = list_.springOf(index);
        if (spring && first != (second->depth > 0) && !(places[first ? 0 : 1].depth > 0))
        {
            std::swap(*spring, *list_.springOf(index + 1));
        }
        // Each place damps half of the mass, if there are two: together they give the restitution that was asked.
        const int loaded = places[0].depth > 0 && places[1].depth > 0 ? 2 : 1;
        load<periodic>(law, index, places[0], timeStep, loaded);
        load<periodic>(law, index + 1, places[1], timeStep, loaded);
        return;
    }
    load<periodic>(law, index, found, timeStep);
    if (second)
    {
        release(law, index + 1);
    }
}

template <class Law>
void World::release(const Law& law, std::size_t index)
{
    if (!(contacts()[index].depth > 0))
    {
        return;
    }
    if (ledger_)
    {
        ledger_->contacts += springEnergyOf(law, index);
    }
    list_.release(index);
}

template <bool periodic, class Law>
void World::load(const Law& law, std::size_t index, const ContactGeometry<2>& geometry, double timeStep, int places)
{
    if (!(geometry.depth > 0))
    {
        release(law, index);
        return;
    }
    Contact<2>& contact = list_.contacts()[index];
    const double previousDepth = contact.depth;
    contact.depth = geometry.depth;
    contact.normal = geometry.normal;
    contact.point = geometry.point;
    loadBodies<periodic>(law, index, previousDepth, timeStep, places);
}

template <bool periodic>
bool World::areFlat(const Contact<2>& contact, const ContactGeometry<2>& found, std::array<ContactGeometry<2>, 2>& places) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    if (contact.withWall())
    {
        return flatContact(shapeOf(i), bodies_.pose[i], walls()[contact.wall()], found, places);
    }
    const auto j = static_cast<std::size_t>(contact.second);
    return flatContact(shapeOf(i), bodies_.pose[i], shapeOf(j), imageOfSecond<periodic>(contact), found, places);
}

template <bool periodic>
Pose<2> World::imageOfSecond(const Contact<2>& contact) const
{
    Pose<2> image = bodies_.pose[static_cast<std::size_t>(contact.second)];
    if constexpr (periodic)
    {
        image.position += offsetOf(contact);
    }
    return image;
}

template <bool periodic>
bool World::touchesGrain(Contact<2>& contact, ContactGeometry<2>& found)
{
    const auto i = static_cast<std::size_t>(contact.first);
    const auto j = static_cast<std::size_t>(contact.second);
    contactStatistics_.queries += settings_.contactStatistics;
    const Vector2& position = bodies_.pose[i].position;
    Vector2 between = bodies_.pose[j].position - position;
    if constexpr (periodic)
    {
        between += offsetOf(contact);
    }
    const double reach = bodies_.boundingRadius[i] + bodies_.boundingRadius[j];
    if (!(between.squaredNorm() <= reach * reach))
    {
        return false;
    }
    // Disks are so cheap that the way to the query of any two shapes would show.
    const Circle* diskI = std::get_if<Circle>(&shapeOf(i));
    const Circle* diskJ = std::get_if<Circle>(&shapeOf(j));
    if (diskI && diskJ)
    {
        const bool touches = diskContact(position, between, diskI->radius(), diskJ->radius(), found);
        contactStatistics_.contacts += settings_.contactStatistics && touches;
        return touches;
    }
    PairStatus status;
    if constexpr (periodic)
    {
        status = queryGrains(contact, imageOfSecond<true>(contact), found);
    }
    else
    {
        status = queryGrains(contact, bodies_.pose[j], found);
    }
    if (status == PairStatus::undecided || status == PairStatus::coarse)
    {
        ++doubtfulQueries_;
    }
    return status == PairStatus::overlapping || status == PairStatus::coarse;
}

PairStatus World::queryGrains(Contact<2>& contact, const Pose<2>& poseJ, ContactGeometry<2>& found)
{
    const auto i = static_cast<std::size_t>(contact.first);
    const auto j = static_cast<std::size_t>(contact.second);
    SearchStart start{contact.normal, contact.turn};
    PairStatus status;
    if (settings_.contactStatistics)
    {
        QueryCost cost;
        status = pairContact(shapeOf(i), bodies_.pose[i], shapeOf(j), poseJ, start, found, cost);
        contactStatistics_.contacts += status == PairStatus::overlapping || status == PairStatus::coarse;
        contactStatistics_.supportCalls += static_cast<std::size_t>(cost.supportCalls);
        contactStatistics_.sweeps += cost.swept;
    }
    else
    {
        status = pairContact(shapeOf(i), bodies_.pose[i], shapeOf(j), poseJ, start, found);
    }
    contact.normal = start.direction;
    contact.turn = static_cast<float>(start.turn);
    return status;
}

bool World::touchesWall(Contact<2>& contact, ContactGeometry<2>& found) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    const PlaneWall<2>& wall = walls()[contact.wall()];
    const Pose<2>& pose = bodies_.pose[i];
    if (!(nearestTo(wall, pose.position) <= bodies_.boundingRadius[i] + walls_.halfThickness(contact.wall())))
    {
        return false;
    }
    SearchStart start{contact.normal, contact.turn};
    const bool touches = wallContact(shapeOf(i), pose, wall, start, found);
    contact.normal = start.direction;
    contact.turn = static_cast<float>(start.turn);
    return touches;
}

double World::effectiveRadius(const Contact<2>& contact) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    const double radius = curvatureRadius(shapeOf(i), bodies_.pose[i].rotation.applyInverse(contact.normal));
    if (contact.withWall())
    {
        return radius;
    }
    const auto j = static_cast<std::size_t>(contact.second);
    const double other = curvatureRadius(shapeOf(j), bodies_.pose[j].rotation.applyInverse(-contact.normal));
    return radius * (other / (radius + other));
}

double World::rollingRadius(const Contact<2>& contact) const
{
    const double radius = sizeOf(static_cast<std::size_t>(contact.first)) / 2;
    if (contact.withWall())
    {
        return radius;
    }
    const double other = sizeOf(static_cast<std::size_t>(contact.second)) / 2;
    return radius * other / (radius + other);
}

template <bool periodic, class Law>
void World::loadBodies(const Law& law, std::size_t index, double previousDepth, double timeStep, int places)
{
    Contact<2>& contact = list_.contacts()[index];
    const auto i = static_cast<std::size_t>(contact.first);
    const Vector2 armI = contact.point - bodies_.pose[i].position;
    const Vector2 velocityI = bodies_.velocity[i] + velocityAt(bodies_.angularVelocity[i], armI);
    double inverseMass = bodies_.inverseMass[i];
    double relativeSpin = bodies_.angularVelocity[i];
    Vector2 relative = velocityI;
    Vector2 armJ = Vector2::Zero();
    Vector2 imageVelocity = Vector2::Zero();
    const bool withWall = contact.withWall();
    const std::size_t j = withWall ? i : static_cast<std::size_t>(contact.second);
    if (withWall)
    {
        relative -= walls_.states()[contact.wall()].velocity;
    }
    else
    {
        armJ = contact.point - bodies_.pose[j].position;
        if constexpr (periodic)
        {
            armJ -= offsetOf(contact);
            imageVelocity = cell_->velocityGradient * offsetOf(contact);
        }
        relative -= bodies_.velocity[j] + velocityAt(bodies_.angularVelocity[j], armJ) + imageVelocity;
        relativeSpin -= bodies_.angularVelocity[j];
        inverseMass += bodies_.inverseMass[j];
    }
    if (contact.depth > shallow_ && contact.depth > previousDepth)
    {
        noteDepth(contact, timeStep * relative.norm());
    }
    ContactState<2> state{contact.depth, contact.normal, relative, places * inverseMass, 0, previousDepth};
    if (anticipates_)
    {
        state.anticipates = true;
        const Vector2 gain = withWall ? expectedGains_[i] : Vector2(expectedGains_[i] - expectedGains_[j]);
        state.expectedGain = gain.dot(contact.normal);
        state.previousForce = -contact.force.dot(contact.normal);
    }
    if constexpr (Law::usesCurvature)
    {
        // Held while they touch, so that the force has a potential: a radius that changed on the way would make energy.
        double& radius = list_.radiusOf(index);
        radius = previousDepth > 0 && radius > 0 ? radius : effectiveRadius(contact);
        state.effectiveRadius = radius;
    }
    double* loss = ledger_ ? &ledger_->contacts : nullptr;
    const ContactForce<2> result = contactForce(law, state, timeStep, list_.springOf(index), loss);
    if constexpr (Law::usesCurvature)
    {
        noteStiffness(i, j, result.springs);
    }
    contact.force = result.force;
    if constexpr (periodic)
    {
        if (ledger_)
        {
            ledger_->walls += timeStep * contact.force.dot(imageVelocity);
        }
    }

    bodies_.force[i] += contact.force;
    bodies_.torque[i] += torqueOf(armI, contact.force);
    if (withWall)
    {
        walls_.add(contact.wall(), -contact.force, result.springs.normalStiffness, result.damping);
    }
    else
    {
        bodies_.force[j] -= contact.force;
        bodies_.torque[j] -= torqueOf(armJ, contact.force);
    }
    if (double* turned = list_.turnOf(index); turned && law.rollingFriction > 0)
    {
        const double torque = rollingTorque(
            law.rollingFriction, rollingRadius(contact), result.pressing, result.springs.normalStiffness, relativeSpin, timeStep,
            *turned, loss);
        bodies_.torque[i] += torque;
        if (!withWall)
        {
            bodies_.torque[j] -= torque;
        }
    }
}

/// A contact that grows too deep is about to pass through; one that was made so deep may relax.
void World::noteDepth(const Contact<2>& contact, double way)
{
    double radii = innerRadiusOf(static_cast<std::size_t>(contact.first));
    if (!contact.withWall())
    {
        radii += innerRadiusOf(static_cast<std::size_t>(contact.second));
    }
    const bool endless = contact.withWall() && !walls()[contact.wall()].plate;
    if (contact.depth > mostDepth(radii, way) && !endless && !tooDeep_)
    {
        tooDeep_ = true;
        brokenGrain_ = static_cast<std::size_t>(contact.first);
    }
}

void World::noteStiffness(std::size_t i, std::size_t j, const ContactSprings& springs)
{
    const auto bound = [this](std::size_t grain) { return stiffness_[static_cast<std::size_t>(bodies_.shape[grain])]; };
    if (std::max(springs.normalStiffness, springs.tangentialStiffness) > std::min(bound(i), bound(j)) && !tooDeep_)
    {
        tooDeep_ = true;
        brokenGrain_ = i;
    }
}

double World::contactEnergy() const
{
    const auto sumOver = [this](const auto& laws)
    {
        double sum = 0;
        for (std::size_t i = 0; i < contacts().size(); ++i)
        {
            sum += contacts()[i].depth > 0 ? energyOf(lawOf(laws, contacts()[i]), i) : 0;
        }
        return sum;
    };
    return std::visit(sumOver, settings_.contact);
}

template <class Law>
ContactState<2> World::stateAtRest(std::size_t index) const
{
    ContactState<2> state{contacts()[index].depth, contacts()[index].normal, Vector2::Zero(), 0};
    if constexpr (Law::usesCurvature)
    {
        state.effectiveRadius = list_.radii()[index];
    }
    return state;
}

template <class Law>
double World::energyOf(const Law& law, std::size_t index) const
{
    const ContactState<2> state = stateAtRest<Law>(index);
    return elasticEnergy(law, state, 0.0) + springEnergyOf(law, index);
}

template <class Law>
double World::springEnergyOf(const Law& law, std::size_t index) const
{
    const ContactSprings stiffness = law.springs(stateAtRest<Law>(index));
    double energy = springs().empty() ? 0 : 0.5 * stiffness.tangentialStiffness * springs()[index] * springs()[index];
    if (const std::vector<double>& turns = list_.turns(); !turns.empty())
    {
        const double arm = law.rollingFriction * rollingRadius(contacts()[index]);
        energy += 0.5 * rollingStiffness * stiffness.normalStiffness * arm * arm * turns[index] * turns[index];
    }
    return energy;
}

} // namespace chesil
