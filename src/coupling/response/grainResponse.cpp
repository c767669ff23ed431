#include "coupling/response/grainResponse.hpp"

#include <cmath>

namespace chesil
{

namespace
{

/// m_c over the displaced fluid's mass, and t; see the class.
constexpr double virtualMass = 1;
constexpr double relaxation = 1.0 / 3;

} // namespace

GrainResponse::GrainResponse(World& world, double fluidDensity, double shareOfStable)
: world_(world),
  fluidDensity_(fluidDensity),
  remainder_(world.bodies().size()),
  acceleration_(world.bodies().size(), Vector2::Zero()),
  angularAcceleration_(world.bodies().size(), 0.0)
{
    world_.immerse(fluidDensity, virtualMass);
    longestSubstep_ = shareOfStable * world_.stableTimeStep();
}

GrainLoads GrainResponse::hydrodynamicLoads(const GrainLoads& forcing) const
{
    GrainLoads loads = forcing;
    for (std::size_t i = 0; i < loads.force.size(); ++i)
    {
        loads.force[i] += fluidDensity_ * world_.areaOf(i) * acceleration_[i];
        loads.torque[i] += fluidDensity_ * world_.polarMomentOf(i) * angularAcceleration_[i];
    }
    return loads;
}

StepStatus GrainResponse::advance(const GrainLoads& forcing, double interval)
{
    if (!(interval > 0) || !std::isfinite(interval))
    {
        return StepStatus::badTimeStep;
    }
    const Bodies<2>& bodies = world_.bodies();
    const GrainLoads loads = hydrodynamicLoads(forcing);
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const double displaced = virtualMass * fluidDensity_;
        const Vector2 force = loads.force[i] + displaced * world_.areaOf(i) * acceleration_[i];
        const double torque = loads.torque[i] + displaced * world_.polarMomentOf(i) * angularAcceleration_[i];
        remainder_.force[i] += relaxation * (force - remainder_.force[i]);
        remainder_.torque[i] += relaxation * (torque - remainder_.torque[i]);
    }
    world_.setExternalLoads(remainder_.force, remainder_.torque);

    const std::vector<Vector2> velocity = bodies.velocity;
    const std::vector<double> angularVelocity = bodies.angularVelocity;
    substeps_ = std::isfinite(longestSubstep_) ? static_cast<int>(std::ceil(interval / longestSubstep_)) : 1;
    const double substep = interval / substeps_;
    world_.updateForces();
    for (int step = 0; step < substeps_; ++step)
    {
        const StepStatus status = world_.step(substep);
        if (status != StepStatus::done)
        {
            return status;
        }
    }

    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        acceleration_[i] = (bodies.velocity[i] - velocity[i]) / interval;
        angularAcceleration_[i] = (bodies.angularVelocity[i] - angularVelocity[i]) / interval;
    }
    return StepStatus::done;
}

} // namespace chesil
