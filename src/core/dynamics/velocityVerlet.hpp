#pragma once

#include "core/dynamics/bodies.hpp"

namespace chesil
{

// Velocity Verlet in its kick-drift-kick form: second order in the time step for forces that depend on
// positions, symplectic without damping.

/// Velocity of one body over `interval` [s], its force held.
inline void kick(Bodies<2>& bodies, std::size_t i, double interval)
{
    bodies.velocity[i] += interval * bodies.inverseMass[i] * bodies.force[i];
    bodies.angularVelocity[i] += interval * bodies.inverseInertia[i] * bodies.torque[i];
}

/// Pose of one body over `interval` [s], its velocity held.
inline void drift(Bodies<2>& bodies, std::size_t i, double interval)
{
    Pose<2>& pose = bodies.pose[i];
    pose.position += interval * bodies.velocity[i];
    pose.rotation.turn(interval * bodies.angularVelocity[i]);
}

/// Of all bodies.
inline void kick(Bodies<2>& bodies, double interval)
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        kick(bodies, i, interval);
    }
}

inline void drift(Bodies<2>& bodies, double interval)
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        drift(bodies, i, interval);
    }
}

} // namespace chesil
