#pragma once

#include "core/world/world.hpp"
#include "coupling/forcing/grainForcing.hpp"

namespace chesil
{

/// Moves grains through one time step of the flow, in substeps of the contact engine.
///
/// The hydrodynamic load is that of the forcing and the inertia of the fluid inside the grain, which moves with
/// it, m_f dU/dt (Uhlmann 2005). The load is known from the last flow step only and holds the added mass with
/// it: lagging by one step it would be unstable for light grains. A virtual mass on both sides,
///
///     (m + c m_f) dU/dt = F + (c + 1) m_f (dU/dt)_last step,
///
/// changes nothing to first order in the time step and is stable as long as the added mass of the flow is below
/// m + 2 c m_f, thus for c = 1 at any density of a grain whose added mass is less than twice the fluid it
/// displaces (a disk's is once). doc/coupling.md derives it.
class GrainResponse
{
public:
    /// Immerses the world's grains in fluid of the given density [kg/m3]. `shareOfStable`: the contact engine's
    /// substep over its stable one.
    GrainResponse(World& world, double fluidDensity, double shareOfStable);

    /// Moves the grains over `interval` [s] under the forcing's loads, summed over all ranks.
    StepStatus advance(const GrainLoads& forcing, double interval);

    /// Force on grain i in the last step, that of the inside fluid included; buoyancy is not [N/m].
    const GrainLoads& hydrodynamicLoads() const { return hydrodynamic_; }

    /// Substeps of the last step.
    int substeps() const { return substeps_; }

private:
    World& world_;
    double fluidDensity_;
    double longestSubstep_;
    GrainLoads hydrodynamic_;
    std::vector<Vector2> acceleration_;
    std::vector<double> angularAcceleration_;
    int substeps_ = 0;
};

} // namespace chesil
