#pragma once

#include "core/dynamics/bodies.hpp"

namespace chesil
{

/// Takes `share` of a force's magnitude away where it drives the motion, adds it where it brakes.
inline double locallyDamped(double force, double velocity, double share)
{
    if (force * velocity > 0)
    {
        return (1 - share) * force;
    }
    return force * velocity < 0 ? (1 + share) * force : force;
}

/// Local non-viscous damping (Cundall 1987, PFC's default with share 0.7): each component of the unbalanced
/// force and torque is lowered by `share` of its magnitude against the velocity. Gravity is damped too: a
/// falling grain accelerates with (1 - share) g. At rest nothing is added. Velocities count against `flow(i)` [m/s].
template <class Flow>
void dampLocally(Bodies<2>& bodies, double share, const Flow& flow)
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const Vector2 velocity = bodies.velocity[i] - flow(i);
        for (int k = 0; k < 2; ++k)
        {
            bodies.force[i][k] = locallyDamped(bodies.force[i][k], velocity[k], share);
        }
        bodies.torque[i] = locallyDamped(bodies.torque[i], bodies.angularVelocity[i], share);
    }
}

} // namespace chesil
