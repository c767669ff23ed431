#pragma once

#include "core/base/tolerances.hpp"
#include "core/narrowphase/polytope.hpp"

namespace chesil
{

/// How EPA ended.
enum class EpaStatus
{
    converged,
    /// The polytope is full; the depth is right within `residual`.
    capacityReached,
};

template <int Dim>
struct EpaResult
{
    EpaStatus status;
    /// Penetration depth [m], >= 0: how far B must move along the normal to leave A.
    double depth;
    /// Unit normal, from A to B.
    Vector<Dim> normal;
    /// Middle of the two deepest points, relative to A's centroid, world axes [m].
    Vector<Dim> point;
    /// Difference of the upper and lower bound of the depth [m].
    double residual;
};

/// Penetration of two overlapping shapes: the polytope that GJK left is grown towards the boundary of A - B
/// until support point and nearest facet agree to `tolerance` times the sum of the radii. Source: Lai & Huang,
/// section 3.2; van den Bergen 2001.
template <int Dim, class Difference>
EpaResult<Dim> epa(const Difference& difference, const Simplex<Dim>& simplex, double tolerance = tolerances::expandingPolytope)
{
    const double enough = std::max(tolerance, tolerances::supportRounding) * difference.size();
    Polytope<Dim> polytope(simplex);
    while (true)
    {
        const Facet<Dim> facet = polytope.nearestFacet();
        const SupportVertex<Dim> vertex = difference.support(facet.normal);
        const double depth = vertex.difference.dot(facet.normal);
        const double residual = depth - facet.distance;
        const bool done = residual <= enough || polytope.hasAsEnd(facet, vertex);
        if (done || polytope.full())
        {
            const Vector<Dim> point = polytope.pointOnA(facet) - 0.5 * depth * facet.normal;
            return {done ? EpaStatus::converged : EpaStatus::capacityReached, std::max(depth, 0.0), facet.normal, point, residual};
        }
        polytope.expand(facet, vertex);
    }
}

} // namespace chesil
