#pragma once

#include "core/base/pose.hpp"
#include "core/base/vector.hpp"

#include <cstddef>
#include <vector>

namespace chesil
{

/// Angular velocity or torque: a number in the plane.
template <int Dim>
struct AngularType;

template <>
struct AngularType<2>
{
    using Type = double;
};

template <int Dim>
using Angular = typename AngularType<Dim>::Type;

/// Torque of a force at an arm.
inline double torqueOf(const Vector2& arm, const Vector2& force)
{
    return cross(arm, force);
}

/// Velocity that a turning body has at an arm from its centroid.
inline Vector2 velocityAt(double angularVelocity, const Vector2& arm)
{
    return angularVelocity * perpendicular(arm);
}

/// The state of all grains, one contiguous array a quantity; entry i of each belongs to grain i. World
/// frame, SI, per unit depth in 2D.
template <int Dim>
struct Bodies
{
    std::vector<Pose<Dim>> pose;
    std::vector<Vector<Dim>> velocity;
    std::vector<Angular<Dim>> angularVelocity;
    std::vector<Vector<Dim>> force;
    std::vector<Angular<Dim>> torque;
    /// 1/mass [1/kg] and 1/inertia [1/(kg m2)]; 0 for a body that does not move.
    std::vector<double> inverseMass;
    std::vector<double> inverseInertia;
    /// Index of the shape.
    std::vector<int> shape;
    std::vector<double> boundingRadius;

    std::size_t size() const { return pose.size(); }

    void reserve(std::size_t bodies)
    {
        pose.reserve(bodies);
        velocity.reserve(bodies);
        angularVelocity.reserve(bodies);
        force.reserve(bodies);
        torque.reserve(bodies);
        inverseMass.reserve(bodies);
        inverseInertia.reserve(bodies);
        shape.reserve(bodies);
        boundingRadius.reserve(bodies);
    }
};

} // namespace chesil
