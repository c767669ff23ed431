#pragma once

#include "core/narrowphase/epa.hpp"
#include "core/narrowphase/gjk.hpp"

#include <algorithm>
#include <cmath>

/// GJK and EPA together, as the pair contact uses them, and what they promise.
namespace chesil::test
{

/// Promise of EPA: the depth is right within this share of the sum of the radii. The bounds that it closes
/// carry the rounding of one support difference each.
constexpr double promisedDepth = tolerances::expandingPolytope + 2 * tolerances::supportRounding;

struct PairAnswer
{
    GjkStatus status = GjkStatus::separated;
    EpaStatus epaStatus = EpaStatus::converged;
    double depth = 0;
    Vector2 normal = Vector2::Zero();
    /// World [m].
    Vector2 point = Vector2::Zero();
    /// Sum of both bounding radii [m].
    double size = 0;
    /// Promise of EPA [m]; if its polytope is full, as between disks that nearly share their centre, it knows
    /// no more than the distance of its two bounds.
    double depthError = 0;

    bool overlaps() const { return status == GjkStatus::overlapping; }
};

template <class ShapeA, class ShapeB>
PairAnswer query(const ShapeA& a, const Pose<2>& poseA, const ShapeB& b, const Pose<2>& poseB,
                 Vector2 direction = Vector2::Zero())
{
    const MinkowskiDifference<2, ShapeA, ShapeB> difference(a, poseA, b, poseB);
    if (direction == Vector2::Zero())
    {
        direction =
            difference.centreToCentre() == Vector2::Zero() ? Vector2(1, 0) : difference.centreToCentre();
    }
    const GjkResult<2> search = gjk<2>(difference, direction);
    PairAnswer answer;
    answer.status = search.status;
    answer.size = difference.size();
    answer.depthError = promisedDepth * answer.size;
    if (answer.overlaps())
    {
        const EpaResult<2> penetration = epa<2>(difference, search.simplex);
        answer.epaStatus = penetration.status;
        answer.depthError += penetration.status == EpaStatus::converged ? 0 : penetration.residual;
        answer.depth = penetration.depth;
        answer.normal = penetration.normal;
        answer.point = poseA.position + penetration.point;
    }
    return answer;
}

/// A and B turned by nothing, A at the origin.
template <class ShapeA, class ShapeB>
PairAnswer query(const ShapeA& a, const ShapeB& b, const Vector2& positionB, double angleB = 0)
{
    return query(a, Pose<2>{}, b, Pose<2>{positionB, Rotation<2>(angleB)});
}

/// The separation of two convex shapes (negative: the depth of penetration) is the largest value over all
/// angles of g(n) = n.(cB - cA) - hA(n) - hB(-n). Found by a dense sweep over the angle, then golden section
/// around every local maximum that could be the largest. No GJK in it.
template <class ShapeA, class ShapeB>
class SeparationSweep
{
public:
    SeparationSweep(const ShapeA& a, const Pose<2>& poseA, const ShapeB& b, const Pose<2>& poseB)
        : difference_(a, poseA, b, poseB)
    {
    }

    double at(double angle) const
    {
        const Vector2 normal(std::cos(angle), std::sin(angle));
        return -difference_.support(normal).difference.dot(normal);
    }

    double largest(int angles = 20000) const
    {
        const double step = 2 * M_PI / angles;
        std::vector<double> values;
        for (int i = 0; i < angles; ++i)
        {
            values.push_back(at(i * step));
        }
        const double best = *std::max_element(values.begin(), values.end());
        // g changes by at most the reach of A - B an angle.
        const double reach = difference_.size() + difference_.centreToCentre().norm();
        double refined = best;
        for (int i = 0; i < angles; ++i)
        {
            const double before = values[static_cast<std::size_t>(i == 0 ? angles - 1 : i - 1)];
            const double after = values[static_cast<std::size_t>(i + 1 == angles ? 0 : i + 1)];
            const double here = values[static_cast<std::size_t>(i)];
            if (here >= before && here >= after && here + reach * step >= best)
            {
                refined = std::max(refined, climbed((i - 1) * step, (i + 1) * step));
            }
        }
        return refined;
    }

private:
    double climbed(double low, double high) const
    {
        constexpr double golden = 0.6180339887498949;
        double inner = high - golden * (high - low);
        double outer = low + golden * (high - low);
        double atInner = at(inner);
        double atOuter = at(outer);
        for (int i = 0; i < 60; ++i)
        {
            if (atInner < atOuter)
            {
                low = inner;
                inner = outer;
                atInner = atOuter;
                outer = low + golden * (high - low);
                atOuter = at(outer);
            }
            else
            {
                high = outer;
                outer = inner;
                atOuter = atInner;
                inner = high - golden * (high - low);
                atInner = at(inner);
            }
        }
        return std::max(atInner, atOuter);
    }

    MinkowskiDifference<2, ShapeA, ShapeB> difference_;
};

} // namespace chesil::test
