#pragma once

#include "core/base/pose.hpp"
#include "core/base/vector.hpp"
#include "core/boundary/wallMotion.hpp"
#include "core/shapes/shape.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace chesil
{

/// What a wall is that ends: a thin plate, in a frame at the middle of its length that stands as the world's.
struct Plate
{
    Shape outline;
    /// From the middle to the second end [m].
    Vector2 half;
};

/// A flat wall without end: grains live on the side that the normal points to. Or a plate: they live on both.
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
    /// Its middle is `point`.
    std::optional<Plate> plate{};

    Pose<Dim> pose() const { return {point, {}}; }

    /// From the plane [m]; positive on the normal's side.
    double distance(const Vector<Dim>& position) const { return (position - point).dot(normal); }
};

/// From a position to the nearest point of the wall's plane, or of its plate's middle line [m]; not negative for a plate.
inline double nearestTo(const PlaneWall<2>& wall, const Vector2& position)
{
    if (!wall.plate)
    {
        return wall.distance(position);
    }
    const Vector2& half = wall.plate->half;
    const Vector2 arm = position - wall.point;
    const double along = std::max(-1.0, std::min(arm.dot(half) / half.squaredNorm(), 1.0));
    return (arm - along * half).norm();
}

/// The grain's point deepest in the wall (its foot point, world frame [m]) by one support call.
template <int Dim, class ShapeType>
Vector<Dim> footPoint(const ShapeType& shape, const Pose<Dim>& pose, const PlaneWall<Dim>& wall)
{
    return pose.toWorld(shape.support(pose.rotation.applyInverse(-wall.normal)));
}

} // namespace chesil
