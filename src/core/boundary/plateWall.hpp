#pragma once

#include "core/base/setupError.hpp"
#include "core/boundary/planeWall.hpp"

#include <cmath>
#include <string>

namespace chesil
{

/// A wall from `start` to `end` [m] that grains meet from both sides and at its ends: a rectangle that is `thickness` [m]
/// wide about the line between the two. ValueError unless both lengths are positive and finite.
inline PlaneWall<2> plateWall(const std::string& name, const Vector2& start, const Vector2& end, double thickness)
{
    const Vector2 half = (end - start) / 2;
    const double length = 2 * half.norm();
    if (!(length > 0 && std::isfinite(length)))
    {
        throw ValueError("a wall " + numberText(length) + " m long", "two ends apart from each other");
    }
    if (!(thickness > 0 && std::isfinite(thickness)))
    {
        throw ValueError("a wall " + numberText(thickness) + " m thick", "a positive, finite thickness");
    }
    const Vector2 normal = perpendicular(half) / half.norm();
    const Vector2 aside = thickness / 2 * normal;
    PlaneWall<2> wall{name, start + half, normal};
    wall.plate = Plate{ConvexPolygon({-half - aside, half - aside, half + aside, -half + aside}), half};
    return wall;
}

} // namespace chesil
