#pragma once

#include "core/dynamics/bodies.hpp"

namespace chesil
{

/// Drag against the motion: of force m c v and torque I c w, with the rate c [1/s]. A grain left to itself loses speed as
/// exp(-c t), whatever its size.
/// `flow(i)` is the velocity that the drag of grain i rests on [m/s].
template <class Flow>
void dampViscously(Bodies<2>& bodies, double rate, const Flow& flow)
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        if (bodies.inverseMass[i] > 0)
        {
            bodies.force[i] -= rate / bodies.inverseMass[i] * (bodies.velocity[i] - flow(i));
        }
        if (bodies.inverseInertia[i] > 0)
        {
            bodies.torque[i] -= rate / bodies.inverseInertia[i] * bodies.angularVelocity[i];
        }
    }
}

} // namespace chesil
