#include "core/world/world.hpp"

#include "core/contact/rollingResistance.hpp"
#include "core/dynamics/localDamping.hpp"
#include "core/dynamics/viscousDamping.hpp"
#include "core/measure/energy.hpp"

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
    resolveContacts(timeStep);
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
double World::energyOf(const Law& law, std::size_t index) const
{
    const ContactState<2> state = stateAtRest<Law>(index);
    return elasticEnergy(law, state, 0.0) + springEnergyOf(law.springs(state), law.rollingFriction, index);
}

double World::springEnergyOf(const ContactSprings& stiffness, double rollingFriction, std::size_t index) const
{
    double energy = springs().empty() ? 0 : 0.5 * stiffness.tangentialStiffness * springs()[index] * springs()[index];
    if (const std::vector<double>& turns = list_.turns(); !turns.empty())
    {
        const double arm = rollingFriction * rollingRadius(contacts()[index]);
        energy += 0.5 * rollingStiffness * stiffness.normalStiffness * arm * arm * turns[index] * turns[index];
    }
    return energy;
}

} // namespace chesil
