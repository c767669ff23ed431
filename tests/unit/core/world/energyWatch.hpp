#pragma once

#include "core/measure/energy.hpp"
#include "core/world/world.hpp"

#include <algorithm>
#include <cmath>

namespace chesil::test
{

/// What a run of a scene with a ledger has shown on the way.
struct EnergyWatch
{
    StepStatus status = StepStatus::done;
    /// Most energy that was put in: at the start, and by works one way or the other [J].
    double scale = 0;
    /// Largest rise of kinetic and contact energy over what was put in, and largest residual of the ledger, either
    /// way; as shares of the scale.
    double growth = 0;
    double residual = 0;
    /// Largest kinetic energy [J], and that at the end as a share of the scale.
    double mostKinetic = 0;
    double lastKinetic = 0;
    double largestOverlap = 0;
};

/// Runs a world whose settings ask for the ledger, at `share` of the stable step; looks at every `every`-th step.
inline EnergyWatch watchEnergy(World& world, int steps, double share = 0.5, int every = 1)
{
    EnergyWatch watch;
    double rise = 0;
    double residual = 0;
    world.updateForces();
    const double timeStep = share * world.stableTimeStep();
    for (int i = 0; i < steps; ++i)
    {
        watch.status = world.step(timeStep);
        if (watch.status != StepStatus::done)
        {
            return watch;
        }
        if (i % every != 0 && i + 1 < steps)
        {
            continue;
        }
        const EnergyLedger& ledger = *world.energyLedger();
        const double kinetic = kineticEnergy(world.bodies());
        const double contacts = world.contactEnergy();
        watch.scale = std::max(watch.scale, ledger.start + std::abs(ledger.works()));
        watch.mostKinetic = std::max(watch.mostKinetic, kinetic);
        watch.lastKinetic = kinetic;
        rise = std::max(rise, kinetic + contacts - ledger.start - ledger.works());
        residual = std::max(residual, std::abs(ledger.residual(kinetic, contacts)));
        watch.largestOverlap = std::max(watch.largestOverlap, world.largestRelativeOverlap());
    }
    if (watch.scale > 0)
    {
        watch.growth = rise / watch.scale;
        watch.residual = residual / watch.scale;
        watch.lastKinetic /= watch.scale;
    }
    return watch;
}

} // namespace chesil::test
