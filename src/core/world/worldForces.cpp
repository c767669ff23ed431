#include "core/world/world.hpp"

#include "core/contact/contactForce.hpp"
#include "core/contact/rollingResistance.hpp"
#include "core/dynamics/localDamping.hpp"
#include "core/dynamics/viscousDamping.hpp"
#include "core/measure/energy.hpp"
#include "core/world/flatContact.hpp"
#include "core/world/pairContact.hpp"
#include "core/world/wallContact.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

void World::updateForces(double timeStep)
{
    updateNeighbours();
    applyWeights();
    walls_.clearForces();
    std::visit([&](const auto& laws) { resolveAll(laws, timeStep); }, settings_.contact);
    if (settings_.viscousDamping > 0)
    {
        withLoss(&EnergyLedger::viscousDamping, timeStep, [this] { dampViscously(bodies_, settings_.viscousDamping); });
    }
    if (settings_.localDamping > 0)
    {
        withLoss(&EnergyLedger::localDamping, timeStep, [this] { dampLocally(bodies_, settings_.localDamping); });
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

void World::applyWeights()
{
    const bool loaded = !externalForces_.empty();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        bodies_.force[i] = loaded ? Vector2(weights_[i] + externalForces_[i]) : weights_[i];
        bodies_.torque[i] = loaded ? externalTorques_[i] : 0;
    }
}

template <class Law>
void World::resolveAll(const LawTable<Law>& laws, double timeStep)
{
    const std::size_t entries = list_.contacts().size();
    for (std::size_t i = 0; i < entries; i += list_.placesOf(i))
    {
        resolve(laws, i, timeStep);
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

template <class Law>
void World::resolve(const LawTable<Law>& laws, std::size_t index, double timeStep)
{
    Contact<2>& contact = list_.contacts()[index];
    Contact<2>* second = list_.placesOf(index) == 2 ? &contact + 1 : nullptr;
    const Law& law = lawOf(laws, contact);
    ContactGeometry<2> found;
    if (!(contact.withWall() ? touchesWall(contact, found) : touchesGrain(contact, found)))
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
    if (second && areFlat(contact, found, places))
    {
        // The one corner of a tilted side is the same contact, whichever end of the other shape it is.
        const bool first = contact.depth > 0;
        Vector2* spring = list_.springOf(index);
        if (spring && first != (second->depth > 0) && !(places[first ? 0 : 1].depth > 0))
        {
            std::swap(*spring, *list_.springOf(index + 1));
        }
        load(law, index, places[0], timeStep);
        load(law, index + 1, places[1], timeStep);
        return;
    }
    load(law, index, found, timeStep);
    if (second)
    {
        release(law, index + 1);
    }
}

template <class Law>
void World::release(const Law& law, std::size_t index)
{
    if (ledger_ && contacts()[index].depth > 0)
    {
        ledger_->contacts += springEnergyOf(law, index);
    }
    list_.release(index);
}

template <class Law>
void World::load(const Law& law, std::size_t index, const ContactGeometry<2>& geometry, double timeStep)
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
    loadBodies(law, index, previousDepth, timeStep);
}

bool World::areFlat(const Contact<2>& contact, const ContactGeometry<2>& found, std::array<ContactGeometry<2>, 2>& places) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    if (contact.withWall())
    {
        return flatContact(shapeOf(i), bodies_.pose[i], walls()[contact.wall()], found, places);
    }
    const auto j = static_cast<std::size_t>(contact.second);
    return flatContact(shapeOf(i), bodies_.pose[i], shapeOf(j), bodies_.pose[j], found, places);
}

bool World::touchesGrain(Contact<2>& contact, ContactGeometry<2>& found)
{
    const PairStatus status = queryGrains(contact, found);
    if (status == PairStatus::undecided || status == PairStatus::coarse)
    {
        ++doubtfulQueries_;
    }
    return status == PairStatus::overlapping || status == PairStatus::coarse;
}

PairStatus World::queryGrains(Contact<2>& contact, ContactGeometry<2>& found)
{
    const auto i = static_cast<std::size_t>(contact.first);
    const auto j = static_cast<std::size_t>(contact.second);
    SearchStart start{contact.normal, contact.turn};
    QueryCost cost;
    const PairStatus status = settings_.contactStatistics
        ? pairContact(shapeOf(i), bodies_.pose[i], shapeOf(j), bodies_.pose[j], start, found, cost)
        : pairContact(shapeOf(i), bodies_.pose[i], shapeOf(j), bodies_.pose[j], start, found);
    contact.normal = start.direction;
    contact.turn = start.turn;
    if (!settings_.contactStatistics)
    {
        return status;
    }
    ++contactStatistics_.queries;
    contactStatistics_.contacts += status == PairStatus::overlapping || status == PairStatus::coarse;
    contactStatistics_.supportCalls += static_cast<std::size_t>(cost.supportCalls);
    contactStatistics_.sweeps += cost.swept;
    return status;
}

bool World::touchesWall(const Contact<2>& contact, ContactGeometry<2>& found) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    const PlaneWall<2>& wall = walls()[contact.wall()];
    const Pose<2>& pose = bodies_.pose[i];
    return wall.distance(pose.position) <= bodies_.boundingRadius[i] && wallContact(shapeOf(i), pose, wall, found);
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

template <class Law>
void World::loadBodies(const Law& law, std::size_t index, double previousDepth, double timeStep)
{
    Contact<2>& contact = list_.contacts()[index];
    const auto i = static_cast<std::size_t>(contact.first);
    const Vector2 armI = contact.point - bodies_.pose[i].position;
    const Vector2 velocityI = bodies_.velocity[i] + velocityAt(bodies_.angularVelocity[i], armI);
    double inverseMass = bodies_.inverseMass[i];
    double relativeSpin = bodies_.angularVelocity[i];
    Vector2 relative = velocityI;
    Vector2 armJ = Vector2::Zero();
    const bool withWall = contact.withWall();
    const std::size_t j = withWall ? i : static_cast<std::size_t>(contact.second);
    if (withWall)
    {
        relative -= walls_.states()[contact.wall()].velocity;
    }
    else
    {
        armJ = contact.point - bodies_.pose[j].position;
        relative -= bodies_.velocity[j] + velocityAt(bodies_.angularVelocity[j], armJ);
        relativeSpin -= bodies_.angularVelocity[j];
        inverseMass += bodies_.inverseMass[j];
    }
    // Two driven bodies feel no force; any mass does.
    const double effectiveMass = inverseMass > 0 ? 1 / inverseMass : 0;
    ContactState<2> state{contact.depth, contact.normal, relative, effectiveMass};
    if constexpr (Law::usesCurvature)
    {
        state.effectiveRadius = effectiveRadius(contact);
        state.previousDepth = previousDepth;
    }
    double* loss = ledger_ ? &ledger_->contacts : nullptr;
    const ContactForce<2> result = contactForce(law, state, timeStep, list_.springOf(index), loss);
    if constexpr (Law::usesCurvature)
    {
        noteStiffness(i, j, result.springs);
    }
    contact.force = result.force;

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
ContactState<2> World::stateAtRest(const Contact<2>& contact) const
{
    ContactState<2> state{contact.depth, contact.normal, Vector2::Zero(), 0};
    if constexpr (Law::usesCurvature)
    {
        state.effectiveRadius = effectiveRadius(contact);
    }
    return state;
}

template <class Law>
double World::energyOf(const Law& law, std::size_t index) const
{
    const ContactState<2> state = stateAtRest<Law>(contacts()[index]);
    return elasticEnergy(law, state, Vector2(Vector2::Zero())) + springEnergyOf(law, index);
}

template <class Law>
double World::springEnergyOf(const Law& law, std::size_t index) const
{
    const ContactSprings stiffness = law.springs(stateAtRest<Law>(contacts()[index]));
    double energy = springs().empty() ? 0 : 0.5 * stiffness.tangentialStiffness * springs()[index].squaredNorm();
    if (const std::vector<double>& turns = list_.turns(); !turns.empty())
    {
        const double arm = law.rollingFriction * rollingRadius(contacts()[index]);
        energy += 0.5 * rollingStiffness * stiffness.normalStiffness * arm * arm * turns[index] * turns[index];
    }
    return energy;
}

} // namespace chesil
