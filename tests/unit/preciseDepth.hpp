#pragma once

#include "core/base/pose.hpp"
#include "unit/preciseShape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// Signed depth of two placed convex shapes in long double, between rigorous bounds, by a search over the
/// angle that knows nothing of the kernel's. With
///
///     h(n) = h_A(n) + h_B(-n) - n.(x_B - x_A)
///
/// the height of D = A - B along the unit vector n, the depth is the least h over one turn; negative: minus
/// the distance. Cosine and sine of the poses and the positions are taken as the doubles they are.
namespace chesil::test
{

// --- the difference of two placed shapes ---------------------------------------------------------

/// D = A - B as a disk and a rest. A pose's matrix is a turn times the length of (cosine, sine), which
/// rounding leaves at 1 +- 1e-16: disks stay disks.
class PreciseDifference
{
public:
    PreciseDifference(const PreciseShape& a, const Pose<2>& poseA, const PreciseShape& b,
                      const Pose<2>& poseB)
        : a_(a), b_(b), axisA_(precise(poseA.rotation.apply(Vector2(1, 0)))),
          axisB_(precise(poseB.rotation.apply(Vector2(1, 0)))),
          offset_(precise(poseB.position) - precise(poseA.position)),
          disk_(a.disk() * preciseNorm(axisA_) + b.disk() * preciseNorm(axisB_))
    {
    }

    Real disk() const { return disk_; }
    const PrecisePoint& offset() const { return offset_; }

    PrecisePoint restSupport(const PrecisePoint& direction) const
    {
        const PrecisePoint back{-direction.x, -direction.y};
        return world(axisA_, a_.restSupport(local(axisA_, direction))) -
               world(axisB_, b_.restSupport(local(axisB_, back))) - offset_;
    }

    /// h along a direction of any length > 0 [m].
    Real height(const PrecisePoint& direction) const
    {
        const PrecisePoint unit = preciseUnit(direction);
        return disk_ + preciseDot(unit, restSupport(unit));
    }

private:
    static PrecisePoint world(const PrecisePoint& axis, const PrecisePoint& p)
    {
        return {axis.x * p.x - axis.y * p.y, axis.y * p.x + axis.x * p.y};
    }
    static PrecisePoint local(const PrecisePoint& axis, const PrecisePoint& p)
    {
        return {axis.x * p.x + axis.y * p.y, axis.x * p.y - axis.y * p.x};
    }

    const PreciseShape& a_;
    const PreciseShape& b_;
    PrecisePoint axisA_;
    PrecisePoint axisB_;
    PrecisePoint offset_;
    Real disk_;
};

// --- least height --------------------------------------------------------------------------------

struct PreciseDepth
{
    /// Height along `normal` [m]: the depth, or at most highest - lowest above it.
    Real highest = 0;
    /// No direction has less [m], up to the rounding of long double (some 1e-19 of the sizes).
    Real lowest = 0;
    PrecisePoint normal;
    /// The supports were used up before the two were within the tolerance.
    bool unsettled = false;
    /// Supports of D that it took.
    int supports = 0;
};

/// Branch and bound. Between two directions at which D's furthest points are p and q, h is at least
/// max(n.p, n.q); the least of that is found at the ends, at the normal of the chord pq or, apart from D, at
/// -p or -q. The interval with the lowest bound is cut there, until no bound is below the best height found
/// by more than the tolerance, or the supports are used up.
class DepthSearch
{
public:
    explicit DepthSearch(const PreciseDifference& difference, int mostSupports = 20000)
        : difference_(difference), mostSupports_(mostSupports)
    {
    }

    /// `claim`: a direction of any length > 0 that may be the best one, which saves most of the work if it
    /// is. `tolerance` in [m], to be at least 1e-18 of the sizes.
    PreciseDepth run(const PrecisePoint& claim, Real tolerance)
    {
        result_ = PreciseDepth();
        result_.highest = std::numeric_limits<Real>::infinity();
        intervals_.clear();
        const PrecisePoint n = preciseUnit(claim);
        const Sample ring[4] = {sample(n), sample({-n.y, n.x}), sample({-n.x, -n.y}), sample({n.y, -n.x})};
        for (int i = 0; i < 4; ++i)
        {
            add(ring[i], ring[(i + 1) % 4], tolerance);
        }
        while (!intervals_.empty() && intervals_.front().bound < result_.highest - tolerance &&
               result_.supports < mostSupports_)
        {
            std::pop_heap(intervals_.begin(), intervals_.end(), higher);
            const Interval worst = intervals_.back();
            intervals_.pop_back();
            const Sample middle = sample(worst.cut);
            add(worst.from, middle, tolerance);
            add(middle, worst.to, tolerance);
        }
        // What was thrown away was within the tolerance of a best height that was no lower than the last one.
        result_.unsettled = !intervals_.empty() && intervals_.front().bound < result_.highest - tolerance;
        result_.lowest = result_.unsettled ? intervals_.front().bound : result_.highest - tolerance;
        return result_;
    }

private:
    struct Sample
    {
        PrecisePoint normal;
        PrecisePoint point;
        Real height;
    };
    struct Interval
    {
        Sample from;
        Sample to;
        Real bound;
        PrecisePoint cut;
    };

    static bool higher(const Interval& a, const Interval& b) { return a.bound > b.bound; }

    Sample sample(const PrecisePoint& normal)
    {
        const PrecisePoint point = difference_.restSupport(normal);
        const Real height = preciseDot(normal, point);
        ++result_.supports;
        if (difference_.disk() + height < result_.highest)
        {
            result_.highest = difference_.disk() + height;
            result_.normal = normal;
        }
        return {normal, point, height};
    }

    /// A lower bound, and where to cut to raise it.
    struct Least
    {
        Real value;
        PrecisePoint at;
    };

    static const Least& lower(const Least& a, const Least& b) { return b.value < a.value ? b : a; }

    /// The least of n.point for n between two directions less than a half turn apart.
    static Least leastOnArc(const PrecisePoint& point, const PrecisePoint& from, const PrecisePoint& to)
    {
        const PrecisePoint away{-point.x, -point.y};
        if (preciseCross(from, away) > 0 && preciseCross(away, to) > 0)
        {
            return {-preciseNorm(point), preciseUnit(away)};
        }
        return lower({preciseDot(from, point), from}, {preciseDot(to, point), to});
    }

    /// Each of the two points bounds h on its side of the chord's normal. Without a normal in between (the
    /// points are the same, or both are furthest at one end) the better one does for all.
    static Least leastBetween(const Sample& from, const Sample& to)
    {
        const PrecisePoint chord = to.point - from.point;
        const PrecisePoint across{chord.y, -chord.x};
        if (preciseCross(from.normal, across) > 0 && preciseCross(across, to.normal) > 0)
        {
            const PrecisePoint normal = preciseUnit(across);
            return lower(leastOnArc(from.point, from.normal, normal),
                         leastOnArc(to.point, normal, to.normal));
        }
        const Least one = leastOnArc(from.point, from.normal, to.normal);
        const Least other = leastOnArc(to.point, from.normal, to.normal);
        return one.value > other.value ? one : other;
    }

    void add(const Sample& from, const Sample& to, Real tolerance)
    {
        const Least least = leastBetween(from, to);
        const Real bound = difference_.disk() + least.value;
        if (bound < result_.highest - tolerance)
        {
            const bool inside =
                preciseCross(from.normal, least.at) > 0 && preciseCross(least.at, to.normal) > 0;
            intervals_.push_back({from, to, bound, inside ? least.at : preciseUnit(from.normal + to.normal)});
            std::push_heap(intervals_.begin(), intervals_.end(), higher);
        }
    }

    const PreciseDifference& difference_;
    int mostSupports_;
    PreciseDepth result_;
    std::vector<Interval> intervals_;
};

} // namespace chesil::test
