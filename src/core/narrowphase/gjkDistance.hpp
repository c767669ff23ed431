#pragma once

#include "core/base/tolerances.hpp"
#include "core/narrowphase/gjk.hpp"

#include <algorithm>

namespace chesil
{

template <int Dim>
struct GjkDistance
{
    GjkStatus status;
    /// Distance of the shapes [m]; 0 unless they are separated.
    double distance;
    /// Unit, from A to B.
    Vector<Dim> normal;
    /// The points nearest to each other, relative to A's centroid, world axes [m].
    Vector<Dim> onA;
    Vector<Dim> onB;
};

/// Drops the vertices of a segment that its point nearest the origin does not need and gives that point, as a vertex of
/// A - B with the point of A it came from.
inline SupportVertex<2> nearestPoint(Simplex<2>& simplex)
{
    auto& v = simplex.vertices;
    if (simplex.count == 1)
    {
        return v[0];
    }
    const Vector2 edge = v[1].difference - v[0].difference;
    const double squaredLength = edge.squaredNorm();
    const double share = squaredLength > 0 ? -v[0].difference.dot(edge) / squaredLength : 0;
    if (share >= 1)
    {
        v[0] = v[1];
    }
    if (share <= 0 || share >= 1)
    {
        simplex.count = 1;
        return v[0];
    }
    return {v[0].difference + share * edge, v[0].onA + share * (v[1].onA - v[0].onA)};
}

/// Of two segments that share the newest vertex, keeps the one nearer to the origin.
inline SupportVertex<2> nearestPointOfTriangle(Simplex<2>& simplex)
{
    Simplex<2> first = simplex;
    first.vertices[1] = simplex.vertices[2];
    first.count = 2;
    Simplex<2> second = simplex;
    second.vertices[0] = simplex.vertices[2];
    second.count = 2;
    const SupportVertex<2> ofFirst = nearestPoint(first);
    const SupportVertex<2> ofSecond = nearestPoint(second);
    const bool firstIsNearer = ofFirst.difference.squaredNorm() <= ofSecond.difference.squaredNorm();
    simplex = firstIsNearer ? first : second;
    return firstIsNearer ? ofFirst : ofSecond;
}

template <class Difference>
GjkStatus touchingOrOverlapping(const Difference& difference, const Vector2& direction)
{
    return gjk<2>(difference, direction).status == GjkStatus::overlapping ? GjkStatus::overlapping : GjkStatus::touching;
}

/// Distance of two convex shapes and where it is, on the support contract alone: the simplex walks towards the origin
/// until its nearest point and the newest support plane agree to `tolerance` times the sum of the radii.
/// Gilbert, Johnson & Keerthi 1988; the end by van den Bergen 1999. `direction` is where to look first.
template <class Difference>
GjkDistance<2> gjkDistance(
    const Difference& difference, const Vector2& direction, double tolerance = tolerances::expandingPolytope)
{
    // A smooth boundary takes about one round a digit.
    constexpr int mostRounds = 128;
    const double enough = std::max(tolerance, tolerances::supportRounding) * difference.size();
    const auto ended = [&](GjkStatus status, const SupportVertex<2>& nearest) -> GjkDistance<2>
    {
        const double distance = nearest.difference.norm();
        const Vector2 normal = distance > 0 ? Vector2(nearest.difference / -distance) : Vector2(Vector2::UnitX());
        return {status, status == GjkStatus::separated ? distance : 0, normal, nearest.onA, nearest.onA - nearest.difference};
    };

    Simplex<2> simplex;
    simplex.push(difference.support(direction));
    SupportVertex<2> nearest = simplex.vertices[0];
    for (int round = 0; round < mostRounds; ++round)
    {
        const double distance = nearest.difference.norm();
        if (!std::isfinite(distance))
        {
            return ended(GjkStatus::notFinite, nearest);
        }
        if (distance <= enough)
        {
            // The origin lies on the simplex, which may be within or on the border.
            return ended(touchingOrOverlapping(difference, direction), nearest);
        }
        const SupportVertex<2> vertex = difference.support(-nearest.difference);
        const double bound = vertex.difference.dot(nearest.difference) / distance;
        if (distance - bound <= enough)
        {
            return ended(GjkStatus::separated, nearest);
        }
        simplex.push(vertex);
        if (simplex.count == 3)
        {
            Vector2 towards;
            Simplex<2> triangle = simplex;
            if (enclose(triangle, towards))
            {
                return ended(GjkStatus::overlapping, nearest);
            }
        }
        const SupportVertex<2> nearer = simplex.count == 3 ? nearestPointOfTriangle(simplex) : nearestPoint(simplex);
        if (!(nearer.difference.squaredNorm() < nearest.difference.squaredNorm()))
        {
            // Rounding keeps it from coming nearer.
            return ended(bound > 0 ? GjkStatus::separated : touchingOrOverlapping(difference, direction), nearest);
        }
        nearest = nearer;
    }
    return ended(GjkStatus::iterationLimit, nearest);
}

} // namespace chesil
