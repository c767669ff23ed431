#pragma once

#include "core/world/world.hpp"
#include "coupling/forcing/grainForcing.hpp"

namespace chesil
{

/// Moves grains through one time step of the flow, in substeps of the contact engine.
///
/// The hydrodynamic load H is that of the forcing and the inertia of the fluid inside the grain, which moves with
/// it (Uhlmann 2005). It is known from the last flow step only, and holds the added mass of the surrounding fluid,
/// H = -m_a dU/dt + ...: taken as it is, the step would be unstable as soon as m_a passes the grain's mass m.
/// Two measures, both without effect on steady motion and of first order in the time step:
///
///     (m + m_c) dU/dt = contact + weight + R,      R <- R + t (H + m_c (dU/dt)_last step - R)
///
/// with m_c the displaced fluid's mass (a lone disk's added mass) and t = 1/3. Stable for m_a < 5 m + 6 m_c: grains
/// that crowd in a closed tank reach seven times the displaced mass. doc/coupling.md derives it.
class GrainResponse
{
public:
    /// Immerses the world's grains in fluid of the given density [kg/m3]. `shareOfStable`: the contact engine's
    /// substep over its stable one.
    GrainResponse(World& world, double fluidDensity, double shareOfStable);

    /// Moves the grains over `interval` [s] under the forcing's loads, summed over all ranks. An interval that is not
    /// positive and finite changes nothing: badTimeStep.
    StepStatus advance(const GrainLoads& forcing, double interval);

    /// What the fluid does to the grains: the forcing's loads and the inertia of the inside fluid; without buoyancy.
    GrainLoads hydrodynamicLoads(const GrainLoads& forcing) const;

    /// Substeps of the last step.
    int substeps() const { return substeps_; }

private:
    World& world_;
    double fluidDensity_;
    double longestSubstep_;
    /// R of the class's description.
    GrainLoads remainder_;
    std::vector<Vector2> acceleration_;
    std::vector<double> angularAcceleration_;
    int substeps_ = 0;
};

} // namespace chesil
