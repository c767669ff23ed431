#include "core/world/pairDistance.hpp"

#include "core/narrowphase/firstNormal.hpp"
#include "core/narrowphase/gjkDistance.hpp"

#include <cmath>

namespace chesil
{

namespace
{

/// Relative to A's centroid, as all below.
PairDistance distanceOf(const Penetration<2>& found)
{
    const Vector2 half = found.depth / 2 * found.normal;
    return {found.status, -found.depth, found.normal, found.point + half, found.point - half};
}

template <class Difference>
PairDistance distanceByExpansion(const Difference& difference, const Vector2& normal)
{
    const GjkDistance<2> apart = gjkDistance(difference, normal);
    switch (apart.status)
    {
    case GjkStatus::separated:
    case GjkStatus::touching:
        return {PairStatus::separated, apart.distance, apart.normal, apart.onA, apart.onB};
    case GjkStatus::overlapping:
        return distanceOf(penetrationByExpansion<2>(difference, normal));
    case GjkStatus::notFinite:
        return {PairStatus::notFinite, 0, normal, Vector2::Zero(), Vector2::Zero()};
    case GjkStatus::iterationLimit:
        break;
    }
    return {PairStatus::undecided, 0, normal, Vector2::Zero(), Vector2::Zero()};
}

/// Separated shapes have one valley; overlapping ones are left to the search that proves the valley.
template <class Difference>
PairDistance distanceByValley(const Difference& difference, const Vector2& normal)
{
    Valley valley = ValleySearch<Difference>(difference).from(normal, SeparatedPairs::goOn);
    if (!(valley.height < 0) && valley.status != ValleyStatus::notFinite)
    {
        const Penetration<2> found = penetration(difference, valley.normal);
        if (found.status != PairStatus::separated || !(found.depth < 0))
        {
            return distanceOf(found);
        }
        // The first valley was one behind A: another direction separates them.
        valley = ValleySearch<Difference>(difference).from(unit(found.normal), SeparatedPairs::goOn);
    }
    if (valley.status == ValleyStatus::notFinite)
    {
        return {PairStatus::notFinite, 0, normal, Vector2::Zero(), Vector2::Zero()};
    }
    if (valley.status != ValleyStatus::found)
    {
        return distanceByExpansion(difference, valley.normal);
    }
    if (!valley.onStraightSide)
    {
        // Once more from its own normal: the points then lie on the outlines to rounding.
        const Valley again = ValleySearch<Difference>(difference).from(valley.normal, SeparatedPairs::goOn);
        valley = again.status == ValleyStatus::found ? again : valley;
    }
    return {PairStatus::separated, -valley.height, valley.normal, valley.onA, valley.onA - valley.height * valley.normal};
}

} // namespace

PairDistance pairDistance(
    const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB, const Vector2& direction)
{
    PairDistance result = std::visit(
        [&](const auto& shapeA, const auto& shapeB)
        {
            using Difference = MinkowskiDifference<2, std::decay_t<decltype(shapeA)>, std::decay_t<decltype(shapeB)>>;
            const Difference difference(shapeA, poseA, shapeB, poseB);
            if (!std::isfinite(difference.centreToCentre().squaredNorm()))
            {
                return PairDistance{PairStatus::notFinite, 0, Vector2::UnitX(), Vector2::Zero(), Vector2::Zero()};
            }
            const Vector2 first = firstNormal<2>(direction, difference.centreToCentre());
            if constexpr (Difference::offersCurvature)
            {
                return distanceByValley(difference, first);
            }
            else
            {
                return distanceByExpansion(difference, first);
            }
        },
        a,
        b);
    result.onA += poseA.position;
    result.onB += poseA.position;
    return result;
}

} // namespace chesil
