#pragma once

#include "core/base/tolerances.hpp"
#include "core/narrowphase/gjk.hpp"
#include "core/narrowphase/minkowskiDifference.hpp"
#include "core/narrowphase/polytope.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace chesil::benchmark
{

/// Support calls that are followed, at most.
constexpr int mostCalls = 30;

/// Residual of the depth over the pair's size after each support call; entry k after k + 1 calls. Those
/// after the end hold the last one.
using Residuals = std::array<double, mostCalls>;

/// Smaller residuals are rounding: both methods stop there, as the engine does. EPA that is asked for more
/// splits facets shorter than rounding and leaves for anywhere.
constexpr double floorOfResidual = tolerances::supportRounding;

/// Where EPA stood when it was stopped.
struct EpaState
{
    int calls = 0;
    Vector2 normal = Vector2::Zero();
};

/// EPA from the simplex that GJK left, until the residual is `enough` or the calls are used up.
template <class Difference>
EpaState iterateEpa(const Difference& difference, const Simplex<2>& simplex, int calls, double enough,
                    Residuals& residuals)
{
    Polytope<2> polytope(simplex);
    EpaState state;
    double residual = 1;
    while (state.calls < calls)
    {
        const Facet<2> facet = polytope.nearestFacet();
        const SupportVertex<2> vertex = difference.support(facet.normal);
        residual = (vertex.difference.dot(facet.normal) - facet.distance) / difference.size();
        // A facet whose ends are the support points is an edge of A - B.
        const bool exact = polytope.hasAsEnd(facet, vertex);
        residual = exact ? floorOfResidual : std::max(residual, floorOfResidual);
        residuals[static_cast<std::size_t>(state.calls)] = residual;
        state = {state.calls + 1, facet.normal};
        if (exact || residual <= std::max(enough, floorOfResidual))
        {
            break;
        }
        polytope.expand(facet, vertex);
    }
    std::fill(residuals.begin() + state.calls, residuals.end(), residual);
    return state;
}

/// Newton's step for the direction of least support. About its support point w with outward unit normal n,
/// A - B is a disk of radius rho, the sum of both radii of curvature, centred at w - rho n; the disk's point
/// nearest the origin lies along rho n - w.
inline Vector2 newtonStep(const Vector2& normal, const CurvedVertex<2>& vertex)
{
    return (vertex.radius.value * normal - vertex.difference).normalized();
}

/// By how much [m] that disk's boundary is nearer the origin than its tangent at w: (t.w)^2/(2 (rho - n.w)).
inline double newtonResidual(const Vector2& normal, const CurvedVertex<2>& vertex)
{
    const double aside = cross(normal, vertex.difference);
    const double beyond = vertex.radius.value - normal.dot(vertex.difference);
    // An origin beyond the disk's centre has no minimum near: the iteration is lost.
    return beyond > 0 ? aside * aside / (2 * beyond) : std::numeric_limits<double>::infinity();
}

/// Newton's iteration from a normal to which the `used` calls before have led, up to `calls` in all.
template <class Difference>
void iterateNewton(const Difference& difference, Vector2 normal, int used, int calls, Residuals& residuals)
{
    double residual = used > 0 ? residuals[static_cast<std::size_t>(used - 1)] : 1;
    for (; used < calls && residual > floorOfResidual; ++used)
    {
        const CurvedVertex<2> vertex = difference.curvedSupport(normal);
        residual = std::max(newtonResidual(normal, vertex) / difference.size(), floorOfResidual);
        residuals[static_cast<std::size_t>(used)] = residual;
        normal = newtonStep(normal, vertex);
    }
    std::fill(residuals.begin() + used, residuals.end(), residual);
}

} // namespace chesil::benchmark
