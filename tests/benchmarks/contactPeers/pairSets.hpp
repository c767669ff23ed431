#pragma once

#include "benchmarks/common/referenceDepth.hpp"
#include "core/narrowphase/epa.hpp"
#include "core/narrowphase/gjk.hpp"
#include "core/shapes/shape.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// Random pairs of grains of one kind, as a broad phase hands them over: their bounding circles overlap.
namespace chesil::benchmark
{

enum class Situation
{
    separate, ///< B's centroid anywhere within reach of A's bounding circle, no contact
    shallow,  ///< depth 1e-6..1e-2 of the size
    deep,     ///< centroids 0.05..0.5 of the size apart
};

inline const char* nameOf(Situation situation)
{
    return situation == Situation::separate  ? "separate"
           : situation == Situation::shallow ? "shallow"
                                             : "deep";
}

constexpr double leastShallowDepth = 1e-6;
constexpr double mostShallowDepth = 1e-2;

/// Moves of a warm pair, and how far B goes [of the size] and turns [rad] in each.
constexpr int steps = 10;
constexpr double move = 1e-3;
constexpr double turn = 1e-3;

/// What is true of a pair.
struct Truth
{
    /// Sum of both bounding radii [m].
    double size;
    /// Penetration depth [m], negative without contact.
    Real depth;
};

template <class ShapeType>
struct Pair
{
    const Shape& a;
    const Shape& b;
    const ShapeType& exactA;
    const ShapeType& exactB;
    Pose<2> poseA;

    double size() const { return exactA.boundingRadius() + exactB.boundingRadius(); }
};

template <class ShapeType>
struct PairSet
{
    Situation situation;
    std::vector<Pair<ShapeType>> pairs;
    /// posesB[s][i]: where the B of pair i is after s moves, 0 <= s <= steps.
    std::vector<std::vector<Pose<2>>> posesB;
    /// Before the first and after the last move.
    std::vector<Truth> before;
    std::vector<Truth> after;
};

template <class ShapeType>
OverlappingPoses posesOf(const Pair<ShapeType>& pair, const Pose<2>& poseB)
{
    return {pair.poseA, poseB, poseB.position - pair.poseA.position};
}

template <class ShapeType>
Truth truthOf(const Pair<ShapeType>& pair, const Pose<2>& poseB)
{
    return {pair.size(), referenceDepth(pair.exactA, pair.exactB, posesOf(pair, poseB))};
}

/// To set up pairs, not to judge them: depth [m] by GJK and EPA, -1 without contact.
template <class ShapeType>
double roughDepth(const Pair<ShapeType>& pair, const Pose<2>& poseB)
{
    const MinkowskiDifference<2, ShapeType, ShapeType> difference(pair.exactA, pair.poseA, pair.exactB,
                                                                  poseB);
    const Vector2 offset = poseB.position - pair.poseA.position;
    const GjkResult<2> search = gjk<2>(difference, offset == Vector2::Zero() ? Vector2(1, 0) : offset);
    return search.status == GjkStatus::overlapping ? epa<2>(difference, search.simplex, 1e-12).depth : -1;
}

/// Finds a place where the depth falls through `depth`; at(0) is deeper, at(1) is not.
template <class PoseAt, class ShapeType>
Pose<2> poseOfDepth(const Pair<ShapeType>& pair, const PoseAt& at, double depth)
{
    constexpr int halvings = 40;
    double deeper = 0;
    double other = 1;
    for (int i = 0; i < halvings; ++i)
    {
        const double middle = (deeper + other) / 2;
        (roughDepth(pair, at(middle)) > depth ? deeper : other) = middle;
    }
    return at(deeper);
}

/// B after a move of move * size along `direction` (unit) and a turn by `turned` [rad].
template <class ShapeType>
Pose<2> moved(const Pair<ShapeType>& pair, const Pose<2>& poseB, const Vector2& direction, double turned)
{
    return {poseB.position + move * pair.size() * direction, Rotation<2>(poseB.rotation.angle() + turned)};
}

template <class ShapeType>
bool belongsTo(const Pair<ShapeType>& pair, const Pose<2>& poseB, Situation situation)
{
    const double depth = roughDepth(pair, poseB) / pair.size();
    switch (situation)
    {
    case Situation::separate:
        return depth < 0 && (poseB.position - pair.poseA.position).norm() < pair.size();
    case Situation::shallow:
        return depth >= leastShallowDepth && depth <= mostShallowDepth;
    case Situation::deep:
        return depth > mostShallowDepth;
    }
    return false;
}

/// Where B is at first; may have to be asked again (belongsTo).
template <class ShapeType>
Pose<2> firstPose(const Pair<ShapeType>& pair, Situation situation, test::RandomSource& random)
{
    const double size = pair.size();
    const Vector2 direction = random.direction();
    const Rotation<2> rotation(random.uniform(-M_PI, M_PI));
    const auto apart = [&](double distance) -> Pose<2> {
        return {pair.poseA.position + distance * size * direction, rotation};
    };
    switch (situation)
    {
    case Situation::separate:
        return apart(std::sqrt(random.uniform(0, 1)));
    case Situation::shallow:
        return poseOfDepth(pair, apart, random.logUniform(leastShallowDepth, mostShallowDepth) * size);
    case Situation::deep:
        break;
    }
    return apart(random.uniform(0.05, 0.5));
}

/// Where B goes from `poseB`. A shallow pair slides or rolls and keeps its depth, another one goes on along
/// `heading` (unit) as long as it may.
template <class ShapeType>
Pose<2> nextPose(const Pair<ShapeType>& pair, const Pose<2>& poseB, Situation situation, double turned,
                 double side, Vector2& heading, test::RandomSource& random)
{
    if (situation == Situation::shallow)
    {
        const Vector2 inwards = (pair.poseA.position - poseB.position).normalized();
        const auto turnedOutwards = [&](double share)
        { return moved(pair, poseB, Rotation<2>(side * share * M_PI).apply(inwards), turned); };
        return poseOfDepth(pair, turnedOutwards, roughDepth(pair, poseB));
    }
    for (int attempt = 0; attempt < 1000; ++attempt)
    {
        const Pose<2> next = moved(pair, poseB, heading, turned);
        if (belongsTo(pair, next, situation))
        {
            return next;
        }
        heading = random.direction();
    }
    throw std::runtime_error("contactPeers: a pair cannot move");
}

template <class ShapeType>
PairSet<ShapeType> makePairs(const std::vector<Shape>& grains, Situation situation, int count,
                             std::uint64_t seed)
{
    test::RandomSource random(seed);
    const auto anyGrain = [&]() -> const Shape&
    { return grains[static_cast<std::size_t>(random.integer(0, static_cast<int>(grains.size()) - 1))]; };

    PairSet<ShapeType> set{situation, {}, std::vector<std::vector<Pose<2>>>(steps + 1), {}, {}};
    while (set.pairs.size() < static_cast<std::size_t>(count))
    {
        const Shape& a = anyGrain();
        const Shape& b = anyGrain();
        const Pair<ShapeType> pair{a, b, std::get<ShapeType>(a), std::get<ShapeType>(b), random.pose(1)};
        Pose<2> poseB = firstPose(pair, situation, random);
        if (!belongsTo(pair, poseB, situation))
        {
            continue;
        }
        set.pairs.push_back(pair);
        set.before.push_back(truthOf(pair, poseB));
        set.posesB[0].push_back(poseB);
        const double side = random.integer(0, 1) ? 1 : -1;
        const double turned = random.integer(0, 1) ? turn : -turn;
        Vector2 heading = random.direction();
        for (std::size_t step = 1; step <= steps; ++step)
        {
            poseB = nextPose(pair, poseB, situation, turned, side, heading, random);
            set.posesB[step].push_back(poseB);
        }
        set.after.push_back(truthOf(pair, poseB));
    }
    return set;
}

} // namespace chesil::benchmark
