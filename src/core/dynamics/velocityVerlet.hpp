#pragma once

#include "core/dynamics/bodies.hpp"

namespace chesil
{

// Velocity Verlet in its kick-drift-kick form: second order in the time step for forces that depend on
// positions, symplectic without damping.

/// Velocities over `interval` [s], forces held.
inline void kick(Bodies<2>& bodies, double interval)
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        bodies.velocity[i] += interval * bodies.inverseMass[i] * bodies.force[i];
        bodies.angularVelocity[i] += interval * bodies.inverseInertia[i] * bodies.torque[i];
    }
}

/// Positions over `interval` [s], velocities held.
inline void drift(Bodies<2>& bodies, double interval)
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        Pose<2>& pose = bodies.pose[i];
        pose.position += interval * bodies.velocity[i];
        pose.rotation = Rotation<2>(pose.rotation.angle() + interval * bodies.angularVelocity[i]);
    }
}

} // namespace chesil
