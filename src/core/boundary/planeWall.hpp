#pragma once

#include "core/base/pose.hpp"
#include "core/base/vector.hpp"
#include "core/boundary/wallMotion.hpp"

#include <string>

namespace chesil
{

/// A flat wall without end. Grains live on the side that the normal points to.
template <int Dim>
struct PlaneWall
{
    std::string name;
    /// Any point on the wall [m].
    Vector<Dim> point;
    /// Unit normal, into the domain.
    Vector<Dim> normal;
    /// Index of its material.
    int material = 0;
    WallMotion motion{};

    double distance(const Vector<Dim>& position) const { return (position - point).dot(normal); }
};

/// The grain's point deepest in the wall (its foot point, world frame [m]) by one support call.
template <int Dim, class ShapeType>
Vector<Dim> footPoint(const ShapeType& shape, const Pose<Dim>& pose, const PlaneWall<Dim>& wall)
{
    return pose.toWorld(shape.support(pose.rotation.applyInverse(-wall.normal)));
}

} // namespace chesil
