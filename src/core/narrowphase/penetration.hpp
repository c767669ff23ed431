#pragma once

#include "core/narrowphase/deepestValley.hpp"
#include "core/narrowphase/epa.hpp"
#include "core/narrowphase/gjk.hpp"
#include "core/narrowphase/sectorSweep.hpp"

namespace chesil
{

/// How a search for the contact of two shapes ended.
enum class PairStatus
{
    separated,
    overlapping,
    /// Overlapping, with a depth that is an upper bound: neither sweep nor EPA could prove it the least.
    coarse,
    /// GJK did not decide within its limit; counts as separated.
    undecided,
    /// A pose or shape holds a number that is not finite.
    notFinite,
};

/// Overlap of two shapes, or the direction that separates them. World axes, relative to A's centroid [m].
template <int Dim>
struct Penetration
{
    PairStatus status;
    /// Unit, from A to B: of the contact if they overlap, separating them if not.
    Vector<Dim> normal;
    /// How far B must move along the normal to leave A.
    double depth;
    /// Middle of the overlap along the normal.
    Vector<Dim> point;
};

/// GJK and EPA alone: the reference, and what shapes without curvature get.
template <int Dim, class Difference>
Penetration<Dim> penetrationByExpansion(const Difference& difference, const Vector<Dim>& direction)
{
    const GjkResult<Dim> search = gjk<Dim>(difference, direction);
    switch (search.status)
    {
    case GjkStatus::notFinite:
        return {PairStatus::notFinite, direction, 0, Vector<Dim>::Zero()};
    case GjkStatus::iterationLimit:
        return {PairStatus::undecided, direction, 0, Vector<Dim>::Zero()};
    case GjkStatus::separated:
    case GjkStatus::touching:
        return {PairStatus::separated, search.direction, 0, Vector<Dim>::Zero()};
    case GjkStatus::overlapping:
        break;
    }
    const EpaResult<Dim> expansion = epa<Dim>(difference, search.simplex);
    const bool overlap = expansion.depth > 0;
    const bool converged = expansion.status == EpaStatus::converged;
    const PairStatus status = !overlap ? PairStatus::separated : converged ? PairStatus::overlapping : PairStatus::coarse;
    return {status, expansion.normal, expansion.depth, expansion.point};
}

inline Penetration<2> penetrationIn(const Valley& valley)
{
    const PairStatus status = valley.height > 0 ? PairStatus::overlapping : PairStatus::separated;
    return {status, valley.normal, valley.height, valley.onA - valley.height / 2 * valley.normal};
}

/// By all directions in doubt, what the nearest valley cannot prove. Not inlined: it is rare, and its memory large.
template <class Difference>
[[gnu::noinline]] Penetration<2> penetrationBySweep(const Difference& difference, const Valley& valley, const Doubt& doubt)
{
    difference.countSweep();
    const SweptValley swept = SectorSweep<Difference>(difference, valley).run(doubt);
    if (swept.status == SweepStatus::notFinite)
    {
        return {PairStatus::notFinite, valley.normal, 0, Vector2::Zero()};
    }
    Penetration<2> result = penetrationIn(swept.valley);
    if (swept.status == SweepStatus::capacityReached && result.status == PairStatus::overlapping)
    {
        result.status = PairStatus::coarse;
    }
    return result;
}

/// Contact of two shapes by the nearest valley from `normal` (unit), which last step's normal makes one or two support
/// calls. A direction that separates them ends the search. What the valley cannot prove, a sweep over the
/// directions in doubt does.
template <class Difference>
[[gnu::flatten]] Penetration<2> penetration(const Difference& difference, const Vector2& normal)
{
    ValleySearch<Difference> search(difference);
    const Valley valley = search.from(normal, SeparatedPairs::stop);
    if (valley.status == ValleyStatus::notFinite)
    {
        return {PairStatus::notFinite, normal, 0, Vector2::Zero()};
    }
    Doubt doubt{Doubt::Kind::everywhere};
    if (valley.status != ValleyStatus::roundLimit)
    {
        doubt = valley.height > 0 ? doubtOf(difference, valley) : Doubt{Doubt::Kind::none};
    }
    return doubt.kind == Doubt::Kind::none ? penetrationIn(valley) : penetrationBySweep(difference, valley, doubt);
}

} // namespace chesil
