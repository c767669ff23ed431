#include "unit/core/world/pairFound.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

// Pairs that move little from query to query, each begun where the last one ended.

using namespace chesil;
using test::findPair;
using test::PairFound;

namespace
{

/// B rolls once round A, 1e-3 deep all the way, with the start carried from step to step.
void rollRound(const Shape& a, const Shape& b, double largestTurn)
{
    constexpr int steps = 10000;
    constexpr double depth = 1e-3;
    const double reach = boundingRadius(a) + boundingRadius(b);
    SearchStart carried;
    Vector2 before = Vector2::Zero();
    double worstDepth = 0;
    double worstNormal = 0;
    double worstTurn = 0;
    int calls = 0;
    for (int i = 0; i <= steps; ++i)
    {
        const double angle = 2 * M_PI * i / steps;
        Pose<2> pose{reach * Vector2(std::cos(angle), std::sin(angle)), Rotation<2>(2 * angle)};
        const PairDistance apart = pairDistance(a, Pose<2>{}, b, pose);
        pose.position -= (apart.distance + depth) * apart.normal;
        const PairFound warm = findPair(a, Pose<2>{}, b, pose, carried);
        const PairFound cold = findPair(a, Pose<2>{}, b, pose);
        ASSERT_TRUE(warm.overlaps()) << i;
        ASSERT_TRUE(cold.overlaps()) << i;
        ASSERT_NEAR(warm.contact.depth, depth, 1e-13) << i;
        worstDepth = std::max(worstDepth, std::abs(warm.contact.depth - cold.contact.depth));
        worstNormal = std::max(worstNormal, (warm.contact.normal - cold.contact.normal).norm());
        if (i > 0)
        {
            worstTurn = std::max(worstTurn, (warm.contact.normal - before).norm());
            calls += warm.cost.supportCalls;
        }
        before = warm.contact.normal;
        carried = warm.start;
    }
    EXPECT_LT(worstDepth, 1e-13);
    // The normal is as good as what the search leaves of its angle, by an estimate that a joint of the outline can
    // put out by a digit; the depth there is flat.
    EXPECT_LT(worstNormal, 20 * tolerances::settledNormal);
    EXPECT_LT(worstTurn, largestTurn * 2 * M_PI / steps);
    EXPECT_LT(calls, 1.5 * steps);
}

} // namespace

TEST(RollingPairs, anEggRollingRoundAnEgg) { rollRound(Ellipse(1.2, 0.8), Ellipse(0.7, 0.9), 4); }

TEST(RollingPairs, aPebbleRollingRoundAPebble)
{
    rollRound(PolyBezier(test::ellipseSegments(8, 1.2, 0.8)), PolyBezier(test::ellipseSegments(10, 0.7, 0.9)), 4);
}

TEST(RollingPairs, aWavyPebbleRollingRoundAWavyPebble)
{
    test::RandomSource random(727);
    test::RandomGrainOptions options;
    options.waviness = 0.5;
    const Shape a = test::randomPolyBezier(options, random);
    const Shape b = test::randomPolyBezier(options, random);
    rollRound(a, b, 20);
}
