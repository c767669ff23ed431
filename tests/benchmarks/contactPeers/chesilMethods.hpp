#pragma once

#include "benchmarks/contactPeers/measurement.hpp"
#include "core/world/pairContact.hpp"

namespace chesil::benchmark
{

// =================================================================================================
// The one place that knows how the kernel counts its support calls.
inline PairStatus countedPairContact(const Shape& a, const Pose<2>& poseA, const Shape& b,
                                     const Pose<2>& poseB, SearchStart& start, ContactGeometry<2>& contact,
                                     int& calls)
{
    QueryCost cost;
    const PairStatus status = pairContact(a, poseA, b, poseB, start, contact, cost);
    calls += cost.supportCalls;
    return status;
}
// =================================================================================================

/// The kernel of the solver.
template <class ShapeType>
class ChesilKernel
{
public:
    explicit ChesilKernel(const PairSet<ShapeType>& set) : set_(set) {}

    template <bool judged>
    Answer query(std::size_t step, std::size_t i, SearchStart& start, int& calls) const
    {
        const Pair<ShapeType>& pair = set_.pairs[i];
        const Pose<2>& poseB = set_.posesB[step][i];
        ContactGeometry<2> contact{};
        PairStatus status;
        if constexpr (judged)
        {
            status = countedPairContact(pair.a, pair.poseA, pair.b, poseB, start, contact, calls);
        }
        else
        {
            status = pairContact(pair.a, pair.poseA, pair.b, poseB, start, contact);
        }
        return {status == PairStatus::overlapping || status == PairStatus::coarse, contact.depth};
    }

private:
    const PairSet<ShapeType>& set_;
};

/// A - B that counts.
template <class ShapeType>
class CountingDifference
{
public:
    using Difference = MinkowskiDifference<2, ShapeType, ShapeType>;

    CountingDifference(const Difference& difference, int& calls) : difference_(difference), calls_(calls) {}

    SupportVertex<2> support(const Vector2& direction) const
    {
        ++calls_;
        return difference_.support(direction);
    }

    double size() const { return difference_.size(); }

private:
    const Difference& difference_;
    int& calls_;
};

/// GJK and EPA alone, down to EPA's tolerance.
template <class ShapeType>
class PlainExpansion
{
public:
    PlainExpansion(const PairSet<ShapeType>& set, double tolerance) : set_(set), tolerance_(tolerance) {}

    template <bool judged>
    Answer query(std::size_t step, std::size_t i, SearchStart& start, int& calls) const
    {
        const Pair<ShapeType>& pair = set_.pairs[i];
        const Pose<2>& poseB = set_.posesB[step][i];
        const typename CountingDifference<ShapeType>::Difference difference(pair.exactA, pair.poseA,
                                                                            pair.exactB, poseB);
        if (start.direction == Vector2::Zero())
        {
            start.direction = poseB.position - pair.poseA.position;
        }
        if constexpr (judged)
        {
            return expand(CountingDifference<ShapeType>(difference, calls), start.direction);
        }
        else
        {
            return expand(difference, start.direction);
        }
    }

private:
    template <class Difference>
    Answer expand(const Difference& difference, Vector2& direction) const
    {
        const GjkResult<2> search = gjk<2>(difference, direction);
        if (search.status != GjkStatus::overlapping)
        {
            direction = search.direction;
            return {false, 0};
        }
        const EpaResult<2> result = epa<2>(difference, search.simplex, tolerance_);
        direction = result.normal;
        return {result.depth > 0, result.depth};
    }

    const PairSet<ShapeType>& set_;
    double tolerance_;
};

} // namespace chesil::benchmark
