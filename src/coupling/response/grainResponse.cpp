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
  hydrodynamic_(world.bodies().size()),
  remainder_(world.bodies().size()),
  acceleration_(world.bodies().size(), Vector2::Zero()),
  angularAcceleration_(world.bodies().size(), 0.0)
{
    world_.immerse(fluidDensity, virtualMass);
    longestSubstep_ = shareOfStable * world_.stableTimeStep();
}

StepStatus GrainResponse::advance(const GrainLoads& forcing, double interval)
{
    const Bodies<2>& bodies = world_.bodies();
    hydrodynamic_ = forcing;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const Vector2 inside = fluidDensity_ * world_.areaOf(i) * acceleration_[i];
        const double insideTurning = fluidDensity_ * world_.polarMomentOf(i) * angularAcceleration_[i];
        hydrodynamic_.force[i] += inside;
        hydrodynamic_.torque[i] += insideTurning;
        remainder_.force[i] += relaxation * (hydrodynamic_.force[i] + virtualMass * inside - remainder_.force[i]);
        remainder_.torque[i] +=
            relaxation * (hydrodynamic_.torque[i] + virtualMass * insideTurning - remainder_.torque[i]);
    }
    world_.setExternalLoads(remainder_.force, remainder_.torque);

    const std::vector<Vector2> velocity = bodies.velocity;
    const std::vector<double> angularVelocity = bodies.angularVelocity;
    substeps_ = std::isfinite(longestSubstep_) ? static_cast<int>(std::ceil(interval / longestSubstep_)) : 1;
    const double substep = interval / substeps_;
    world_.updateForces(0);
    for (int step = 0; step < substeps_; ++step)
    {
        if (world_.step(substep) != StepStatus::done)
        {
            return StepStatus::notFinite;
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
