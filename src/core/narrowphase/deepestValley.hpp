#pragma once

#include "core/narrowphase/valley.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

/// Proves without a support call that the height of an overlapping pair's A - B is nowhere below that of a valley
/// found; false if it cannot tell. doc/contactKernel.md, "Is it the right valley?":
///
/// 1. Where no curvature is tighter than the depth, a disk of that radius rolls inside the boundary: any valley is
///    the deepest.
/// 2. A - B holds a disk about minus the line of centres, which leaves a cone of directions to be doubted; and it holds
///    the straight side, or the stretch of bounded curvature, that the valley lies on: if their ends reach as far
///    as the depth at both borders of the cone, they do so everywhere between.
template <class Difference>
bool isDeepest(const Difference& difference, const Valley& valley)
{
    const double depth = valley.height;
    if (depth <= difference.leastRadius())
    {
        return true;
    }
    const double enough = depth - tolerances::supportRounding / 2 * difference.size();
    const double distance = difference.centreToCentre().norm();
    const double reach = difference.innerRadius() - depth;
    if (distance <= reach)
    {
        return true;
    }
    if (distance <= -reach)
    {
        return false;
    }
    const Vector2 along = difference.centreToCentre() / distance;
    const double cosine = reach / distance;
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const Vector2 lastDoubt = cosine * along + sine * perpendicular(along);
    const Vector2 firstDoubt = cosine * along - sine * perpendicular(along);

    Vector2 start = valley.start;
    Vector2 end = valley.end;
    if (!valley.onStraightSide)
    {
        const OutlineStretch stretch = difference.stretchAt(valley.normal);
        if (stretch.leastRadius < depth)
        {
            return false;
        }
        if (stretch.whole)
        {
            return true;
        }
        // No larger than the shapes, so that its centre loses no digits.
        const double radius = std::min(stretch.leastRadius, difference.size());
        const Vector2 centre = valley.end - radius * valley.normal;
        const auto isOnStretch = [&](const Vector2& doubt)
        { return cross(stretch.firstNormal, doubt) >= 0 && cross(doubt, stretch.lastNormal) >= 0; };
        start = isOnStretch(firstDoubt) ? depth * firstDoubt : Vector2(centre + radius * stretch.firstNormal);
        end = isOnStretch(lastDoubt) ? depth * lastDoubt : Vector2(centre + radius * stretch.lastNormal);
    }
    // Less than half a turn from the valley to each border, or the argument does not hold.
    const bool lastSeen = cross(valley.normal, lastDoubt) > 0 && end.dot(lastDoubt) >= enough;
    const bool firstSeen = cross(firstDoubt, valley.normal) > 0 && start.dot(firstDoubt) >= enough;
    return lastSeen && firstSeen;
}

} // namespace chesil
