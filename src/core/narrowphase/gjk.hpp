#pragma once

#include "core/base/tolerances.hpp"
#include "core/narrowphase/simplex.hpp"

namespace chesil
{

/// How a GJK query ended.
enum class GjkStatus
{
    separated,      ///< a direction separates the shapes
    overlapping,    ///< the simplex holds the origin
    touching,       ///< nearer to contact than rounding can tell; counts as no contact
    notFinite,      ///< a support point is not a number: a pose or shape is broken
    iterationLimit, ///< did not decide within the limit; counts as no contact
};

template <int Dim>
struct GjkResult
{
    GjkStatus status;
    Simplex<Dim> simplex;
    /// The direction last searched; separates the shapes if the status says so. World axes.
    Vector<Dim> direction;
};

/// Do two convex shapes overlap? Gilbert, Johnson & Keerthi with the two ends of Lai & Huang, section 3.1:
/// contact when the simplex encloses the origin, no contact when the newest support point does not pass it.
/// `direction` is where to look first (any length but zero): the last step's separating direction makes
/// most misses cost one support call.
template <int Dim, class Difference>
GjkResult<Dim> gjk(const Difference& difference, const Vector<Dim>& direction)
{
    // Every round adds a vertex beyond the last face; smooth shapes at shallow depth need about ten.
    constexpr int mostRounds = 64;
    const double floor = tolerances::supportRounding * difference.size();

    GjkResult<Dim> result{GjkStatus::iterationLimit, {}, direction};
    for (int round = 0; round < mostRounds; ++round)
    {
        const SupportVertex<Dim> vertex = difference.support(result.direction);
        const double reach = vertex.difference.dot(result.direction);
        if (!std::isfinite(reach))
        {
            result.status = GjkStatus::notFinite;
            return result;
        }
        if (reach < 0)
        {
            result.status = GjkStatus::separated;
            return result;
        }
        const double length = result.direction.norm();
        if (result.simplex.count > 0 && reach <= floor * length)
        {
            result.status = GjkStatus::touching;
            return result;
        }
        result.simplex.push(vertex);
        if (enclose(result.simplex, result.direction))
        {
            result.status = GjkStatus::overlapping;
            return result;
        }
        if (result.direction == Vector<Dim>::Zero())
        {
            result.status = GjkStatus::touching;
            return result;
        }
    }
    return result;
}

} // namespace chesil
