#pragma once

#include "core/narrowphase/valley.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

/// Directions in which A - B may be less deep than in a valley.
struct Doubt
{
    enum class Kind
    {
        /// None: the valley is the deepest.
        none,
        /// From `first` counter-clockwise to `last`, less than half a turn; the valley's normal lies between them.
        cone,
        everywhere,
    };

    Kind kind;
    /// Unit.
    Vector2 first = Vector2::Zero();
    Vector2 last = Vector2::Zero();
};

/// Whether the height of A - B is nowhere below `enough` (positive, the valley's but for rounding) from the valley's normal
/// to `border`, less than half a turn ahead; false if it cannot tell. doc/contactKernel.md, "Part by part".
template <class Difference>
bool risesUpTo(const Vector2& border, int sense, const Difference& difference, const Valley& valley, double enough)
{
    // Most settle within four; after so many a sweep is as fast.
    constexpr int mostParts = 32;
    auto ofA = difference.walkA(valley.normal, sense);
    auto ofB = difference.walkB(valley.normal, sense);
    Vector2 normal = valley.normal;
    // A point of A - B: the boundary's own at this normal, or one of it further ahead.
    Vector2 point = sense > 0 ? valley.end : valley.start;
    if (valley.onStraightSide)
    {
        // The ends of a chord are at normals of their own, and parts from here on would count an arc twice.
        return border.dot(point) >= enough;
    }
    for (int i = 0; i < mostParts; ++i)
    {
        Vector2 next = border;
        const bool endsA = ofA.endsBefore(next);
        const bool endsB = ofB.endsBefore(next);
        point += std::min(ofA.leastRadius() + ofB.leastRadius(), difference.size()) * (next - normal);
        if (!(next.dot(point) >= enough) || !(sense * cross(next, point) >= 0))
        {
            return false;
        }
        if (border.dot(point) >= enough)
        {
            return true;
        }
        normal = next;
        if (endsB)
        {
            ofB.advance();
        }
        else if (endsA)
        {
            ofA.advance();
        }
        else
        {
            return true;
        }
    }
    return false;
}

/// Where the height of an overlapping pair's A - B may be below that of a valley found, without a support call.
/// doc/contactKernel.md, "Is it the right valley?":
///
/// 1. Where no curvature is tighter than the depth, a disk of that radius rolls inside the boundary: any valley is
///    the deepest.
/// 2. A - B holds a disk about minus the line of centres, which leaves a cone of directions to be doubted.
/// 3. Both outlines part by part, from the valley on: they bend so little, or have come so far, that the height does not
///    fall below the valley's within the cone.
template <class Difference>
Doubt doubtOf(const Difference& difference, const Valley& valley)
{
    const double depth = valley.height;
    if (depth <= difference.leastRadius())
    {
        return {Doubt::Kind::none};
    }
    const double enough = depth - tolerances::supportRounding / 2 * difference.size();
    const double distance = difference.centreToCentre().norm();
    const double reach = difference.innerRadius() - depth;
    if (distance <= reach)
    {
        return {Doubt::Kind::none};
    }
    if (distance <= -reach)
    {
        return {Doubt::Kind::everywhere};
    }
    const Vector2 along = difference.centreToCentre() / distance;
    const double cosine = reach / distance;
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    const Vector2 lastDoubt = cosine * along + sine * perpendicular(along);
    const Vector2 firstDoubt = cosine * along - sine * perpendicular(along);
    // Less than half a turn from the valley to each border, or the arguments do not hold.
    const bool isBetween = cross(firstDoubt, valley.normal) > 0 && cross(valley.normal, lastDoubt) > 0;
    if (!isBetween)
    {
        return {Doubt::Kind::everywhere};
    }
    if (risesUpTo(lastDoubt, 1, difference, valley, enough) && risesUpTo(firstDoubt, -1, difference, valley, enough))
    {
        return {Doubt::Kind::none};
    }
    return cosine > 0 ? Doubt{Doubt::Kind::cone, firstDoubt, lastDoubt} : Doubt{Doubt::Kind::everywhere};
}

} // namespace chesil
