#pragma once

#include "core/base/vector.hpp"

#include <algorithm>
#include <array>

namespace chesil
{

/// The straight side that another shape presses into: a point on it, its outward unit normal, and how far it reaches
/// from the point along perpendicular(normal) [m].
struct ReferenceSide
{
    Vector2 point;
    Vector2 normal;
    double from;
    double to;
};

/// One end of a flat contact.
struct FlatPlace
{
    /// Overlap there [m]; not positive if this end hangs free.
    double depth;
    /// Unit, out of the reference: its side's normal where a corner of the other shape presses into it; the other side's,
    /// reversed, where a corner of the reference presses into that.
    Vector2 normal;
    /// Middle of the overlap [m].
    Vector2 point;
};

/// Both ends of the contact of a reference side with a straight side of another shape (from `start` to `end`) whose
/// deepest point is `deepest`; in the order of perpendicular(reference.normal). The ends of the shared length
/// are corners of one shape or the other: the depth at each is a smooth function of the poses, so that
/// springs there conserve energy. Where the deepest point lies beyond an end of its side (a rounded corner), it
/// stands in for that end.
inline std::array<FlatPlace, 2> flatPlaces(
    const ReferenceSide& reference, const Vector2& start, const Vector2& end, const Vector2& deepest)
{
    const Vector2 along = perpendicular(reference.normal);
    const auto coordinate = [&](const Vector2& p) { return (p - reference.point).dot(along); };
    const auto depth = [&](const Vector2& p) { return (reference.point - p).dot(reference.normal); };

    // The side runs counter-clockwise in its own shape, against the reference.
    Vector2 low = end;
    Vector2 high = start;
    const bool nearLow = (deepest - low).squaredNorm() <= (deepest - high).squaredNorm();
    // Not a point between them: that of a side exactly parallel is any.
    if (nearLow ? coordinate(deepest) < coordinate(low) : coordinate(deepest) > coordinate(high))
    {
        (nearLow ? low : high) = deepest;
    }

    const auto atCorner = [&](const Vector2& corner, double d) -> FlatPlace
    { return {d, reference.normal, corner + d / 2 * reference.normal}; };
    const auto atEnd = [&](double x) -> FlatPlace
    {
        const Vector2 corner = reference.point + x * along;
        const Vector2 normal = -perpendicular(unit(high - low));
        const double d = (corner - low).dot(normal);
        return {d, normal, corner - d / 2 * normal};
    };
    const double x0 = coordinate(low);
    const double x1 = coordinate(high);
    if (!(std::max(x0, reference.from) < std::min(x1, reference.to)))
    {
        // Nothing shared but a point.
        const FlatPlace whole = atCorner(deepest, depth(deepest));
        const FlatPlace none{0, reference.normal, deepest};
        return nearLow ? std::array<FlatPlace, 2>{whole, none} : std::array<FlatPlace, 2>{none, whole};
    }
    return {
        x0 >= reference.from ? atCorner(low, depth(low)) : atEnd(reference.from),
        x1 <= reference.to ? atCorner(high, depth(high)) : atEnd(reference.to)};
}

} // namespace chesil
