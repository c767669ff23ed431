#pragma once

#include "core/base/vector.hpp"
#include "core/contact/contactGeometry.hpp"

#include <cmath>

namespace chesil
{

/// Contact of two disks by formula; false, and `contact` as it was, if they do not overlap or a number is none. `centreA`
/// [m], `between` leads from there to the centre of the other one [m].
inline bool diskContact(
    const Vector2& centreA, const Vector2& between, double radiusA, double radiusB, ContactGeometry<2>& contact)
{
    const double squaredDistance = between.squaredNorm();
    const double reach = radiusA + radiusB;
    if (!(squaredDistance < reach * reach))
    {
        return false;
    }
    const double distance = std::sqrt(squaredDistance);
    const double depth = reach - distance;
    if (!(depth > 0))
    {
        return false;
    }
    contact.depth = depth;
    contact.normal = distance > 0 ? Vector2(between * (1 / distance)) : Vector2(Vector2::UnitX());
    contact.point = centreA + (radiusA - depth / 2) * contact.normal;
    return true;
}

} // namespace chesil
