#pragma once

#include "benchmarks/paperKernel/packing.hpp"
#include "core/narrowphase/epa.hpp"
#include "core/narrowphase/gjk.hpp"
#include "core/narrowphase/minkowskiDifference.hpp"
#include "core/world/pairContact.hpp"

namespace chesil::benchmark
{

/// Support calls of A - B that one query of a pair takes.
struct PairCalls
{
    bool inContact = false;
    /// GJK from the line of centres, and with EPA to 1e-12.
    int gjk = 0;
    int gjkAndEpa = 0;
    /// The engine's own query, without memory and with that of the step before.
    int engineCold = 0;
    int engineWarm = 0;
    bool coldFellBack = false;
    bool warmFellBack = false;
    /// The engine's depth, cold and warm, less that of EPA, over the pair's size; the larger one. Where they
    /// do not agree on the contact, the depth itself.
    double depthDifference = 0;
};

struct EngineAnswer
{
    QueryCost cost;
    /// [m], 0 without contact.
    double depth = 0;
};

/// The engine's contact query and what it counts.
inline EngineAnswer askEngine(const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB,
                              SearchStart& start)
{
    EngineAnswer answer;
    ContactGeometry<2> contact;
    const PairStatus status = pairContact(a, poseA, b, poseB, start, contact, answer.cost);
    answer.depth = status == PairStatus::overlapping || status == PairStatus::coarse ? contact.depth : 0;
    return answer;
}

/// GJK's and EPA's part of the calls; the depth [m], 0 without contact.
inline double countGjk(const NearPair& pair, PairCalls& calls)
{
    /// The engine's own before it looked for valleys.
    constexpr double tolerance = 1e-12;
    return std::visit(
        [&](const auto& a, const auto& b)
        {
            using A = std::decay_t<decltype(a)>;
            using B = std::decay_t<decltype(b)>;
            QueryCost cost;
            const MinkowskiDifference<2, A, B, CostCounter> difference(a, pair.poseA, b, pair.poseB,
                                                                       CostCounter{&cost});
            const GjkResult<2> search = gjk<2>(difference, difference.centreToCentre());
            calls.inContact = search.status == GjkStatus::overlapping;
            calls.gjk = cost.supportCalls;
            const double depth = calls.inContact ? epa<2>(difference, search.simplex, tolerance).depth : 0;
            calls.gjkAndEpa = cost.supportCalls;
            return depth;
        },
        *pair.a, *pair.b);
}

inline PairCalls countCalls(const NearPair& pair)
{
    PairCalls calls;
    const double depth = countGjk(pair, calls);

    SearchStart start;
    const EngineAnswer cold = askEngine(*pair.a, pair.poseA, *pair.b, pair.poseB, start);
    start = {};
    askEngine(*pair.a, pair.beforeA, *pair.b, pair.beforeB, start);
    const EngineAnswer warm = askEngine(*pair.a, pair.poseA, *pair.b, pair.poseB, start);
    calls.engineCold = cold.cost.supportCalls;
    calls.engineWarm = warm.cost.supportCalls;
    calls.coldFellBack = cold.cost.swept;
    calls.warmFellBack = warm.cost.swept;
    calls.depthDifference =
        std::max(std::abs(cold.depth - depth), std::abs(warm.depth - depth)) / pair.size();
    return calls;
}

} // namespace chesil::benchmark
