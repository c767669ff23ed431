#pragma once

#include "core/base/smallTurn.hpp"
#include "core/narrowphase/minkowskiDifference.hpp"

#include <cmath>

namespace chesil
{

/// How the search for a valley ended.
enum class ValleyStatus
{
    /// A local minimum of the height.
    found,
    /// On the way a direction was met that separates the shapes.
    separated,
    /// No valley within the limit of rounds.
    roundLimit,
    /// A support point is not a number.
    notFinite,
};

/// A local minimum of the height h(n) = max over p in A - B of n.p, over unit normals n. World axes, relative to A's
/// centroid [m].
struct Valley
{
    ValleyStatus status;
    Vector2 normal;
    /// h(normal): the penetration depth; negative for the distance of separated shapes.
    double height;
    /// Deepest point of A in B, or nearest to B.
    Vector2 onA;
    /// The boundary of A - B at this normal: both ends of a straight side, the same point twice elsewhere.
    Vector2 start;
    Vector2 end;
    bool onStraightSide;
};

/// At a support point itself.
inline Valley valleyAt(ValleyStatus status, const Vector2& normal, double height, const CurvedVertex<2>& vertex)
{
    return {status, normal, height, vertex.onA, vertex.difference, vertex.difference, false};
}

/// The bottom from a normal near it, by the circle of curvature there: exact for a boundary that is one, however far it turns.
inline Valley atBottomOfCircle(const Vector2& normal, const CurvedVertex<2>& vertex, double height, double slope)
{
    const Vector2 fromCentre = vertex.radius.value * normal - vertex.difference;
    const double distance = fromCentre.norm();
    if (!(distance > 0))
    {
        return valleyAt(ValleyStatus::found, normal, height, vertex);
    }
    const Vector2 bottom = (1 / distance) * fromCentre;
    const double lowest = height - slope * slope / (distance + vertex.radius.value - height);
    const Vector2 onDifference = lowest * bottom;
    return {
        ValleyStatus::found, bottom, lowest, vertex.onA + vertex.radiusA.value * (bottom - normal), onDifference, onDifference,
        false};
}

/// The bottom from a normal near it, by the series about the normal, to the fourth order of the height
/// (doc/contactKernel.md, "The last step").
inline Valley atBottom(const Vector2& normal, const CurvedVertex<2>& vertex, double height, double slope)
{
    const CurvatureRadius& radius = vertex.radius;
    const double bend = radius.value - height;
    const double inverse = 1 / bend;
    const double first = -slope * inverse;
    if (!(std::abs(first) < smallTurn))
    {
        return atBottomOfCircle(normal, vertex, height, slope);
    }
    const double third = radius.first - slope;
    const double fourth = radius.second - bend;
    // Shares multiplied by, not divided by: none of them needs its last digit, and a division takes as long as four products.
    constexpr double oneThird = 1.0 / 3, oneSixth = 1.0 / 6;
    const double c2 = 0.5 * inverse * third * first;
    const double c3 = oneSixth * inverse * fourth * (first * first);
    const double angle = first * (1 - c2 + 2 * (c2 * c2) - c3);
    const double lowest = height + angle * (slope + angle * (0.5 * bend + angle * (oneSixth * third + (1.0 / 24) * angle * fourth)));
    const Vector2 bottom = turnedBy(angle, normal);
    const CurvatureRadius& a = vertex.radiusA;
    // Along the arc: on a nearly straight side the difference of the two normals has no digits left.
    const double along = angle * (a.value + 0.5 * angle * (a.first + oneThird * angle * (a.second - a.value)));
    const double inwards =
        0.5 * (angle * angle) * (a.value + angle * (2 * oneThird * a.first + 0.25 * angle * (a.second - oneThird * a.value)));
    const Vector2 onA = vertex.onA + along * perpendicular(normal) - inwards * normal;
    const Vector2 onDifference = lowest * bottom;
    return {ValleyStatus::found, bottom, lowest, onA, onDifference, onDifference, false};
}

} // namespace chesil
