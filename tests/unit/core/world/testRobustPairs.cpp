#include "benchmarks/pairRobustness/survey.hpp"

#include <gtest/gtest.h>

using namespace chesil;
using namespace chesil::benchmark;
using test::DepthSearch;
using test::PreciseDepth;
using test::PreciseDifference;
using test::PrecisePoint;
using test::PreciseShape;
using test::RandomSource;

namespace
{

constexpr std::uint64_t seed = 311;

PreciseDepth preciseDepth(const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB)
{
    const PreciseShape preciseA(a);
    const PreciseShape preciseB(b);
    return DepthSearch(PreciseDifference(preciseA, poseA, preciseB, poseB)).run({1, 0}, 1e-17L);
}

void expectDepth(long double expected, const Shape& a, const Shape& b, const Pose<2>& poseB)
{
    const PreciseDepth depth = preciseDepth(a, Pose<2>{}, b, poseB);
    EXPECT_FALSE(depth.unsettled);
    EXPECT_LT(std::abs(depth.highest - expected), 2e-17L) << static_cast<double>(depth.highest);
}

/// The least height of A - B from a dense sweep, each of its minima refined to 1e-12 rad, where a corner
/// leaves that much.
long double sweptDepth(const Outline& outlineA, const Outline& outlineB)
{
    constexpr int samples = 720;
    constexpr double step = 2 * M_PI / samples;
    const test::HeightSweep sweepA(outlineA, 8);
    const test::HeightSweep sweepB(outlineB, 8);
    const auto height = [&](double angle)
    {
        const Vector2 n(std::cos(angle), std::sin(angle));
        return sweepA.height(n) + sweepB.height(-n);
    };
    std::vector<long double> swept;
    for (int i = 0; i < samples; ++i)
    {
        swept.push_back(height(i * step));
    }
    long double least = std::numeric_limits<long double>::infinity();
    for (int i = 0; i < samples; ++i)
    {
        const auto value = [&](int k) { return swept[static_cast<std::size_t>((k + samples) % samples)]; };
        if (value(i) > value(i - 1) || value(i) > value(i + 1))
        {
            continue;
        }
        double low = (i - 1) * step;
        double high = (i + 1) * step;
        while (high - low > 1e-12)
        {
            const double third = (high - low) / 3;
            if (height(low + third) < height(high - third))
            {
                high -= third;
            }
            else
            {
                low += third;
            }
        }
        least = std::min(least, height((low + high) / 2));
    }
    return least;
}

} // namespace

/// Pairs of the benchmark that went wrong once, each with its whole batch: CHESIL_PAIR=<number> prints one.
TEST(RobustPairs, thoseThatFailedOnce)
{
    constexpr std::uint64_t benchmarkSeed = 20250307;
    constexpr int scaleGroups = 32;
    constexpr std::int64_t batchSize = 100;
    const GrainPool pool(benchmarkSeed, scaleGroups);
    const PairMaker maker(pool, benchmarkSeed);
    Survey survey(maker, batchSize);
    // Newton's step from one end of an ellipse to the other and back; a nearly straight side taken for a circle; joints
    // of unlike curves; concentric and identical pairs whose height is nearly constant; a corner on a flat curve;
    // a slender tip between two equal radii; no length between two supports; an arc counted twice at a chord's end.
    for (const std::int64_t pair :
         {46425, 93016, 38100, 77109, 65535, 7849, 95817, 3607996, 15568, 39381, 5997919, 7515, 87847, 31976, 233916,
          5992896, 873537, 6992812, 4792774, 4353148})
    {
        survey.runBatch(pair / batchSize);
    }
    for (int flaw = 0; flaw < flaws; ++flaw)
    {
        const std::vector<Remarkable>& found = survey.remarkable(static_cast<Flaw>(flaw));
        EXPECT_TRUE(found.empty()) << "pair " << found.front().index << ", flaw " << flaw;
    }
}

/// A small tests/benchmarks/pairRobustness: the same classes and bounds.
TEST(RobustPairs, allClassesColdAndWarm)
{
    constexpr int pairs = 40000;
    constexpr int batchSize = 10;
    const GrainPool pool(seed, 4);
    const PairMaker maker(pool, seed);
    Survey survey(maker, batchSize);
    for (int batch = 0; batch < pairs / batchSize; ++batch)
    {
        survey.runBatch(batch);
    }
    const char* const names[flaws] = {"status", "verdict", "geometry", "direction", "depth"};
    for (int flaw = 0; flaw < flaws; ++flaw)
    {
        const std::vector<Remarkable>& found = survey.remarkable(static_cast<Flaw>(flaw));
        EXPECT_TRUE(found.empty()) << names[flaw] << " of pair " << found.front().index
                                   << (found.front().warm ? " warm" : "") << " of seed " << seed << ", "
                                   << situationName(static_cast<int>(found.front().stratum.situation)) << ' '
                                   << found.front().stratum.types();
    }
    const Tally well = survey.sum([](const Stratum& stratum) { return stratum.wellScaled; });
    EXPECT_LE(well.worstError, 1e-12);
    // All is there: contacts and none, and a reference that knew.
    const Tally all = survey.sum([](const Stratum&) { return true; });
    EXPECT_EQ(all.pairs, pairs);
    EXPECT_GT(all.contacts, all.pairs / 2);
    EXPECT_LT(all.contacts, 2 * all.pairs * 9 / 10);
    EXPECT_LT(all.unsettled, all.pairs / 1000);
}

TEST(RobustPairs, referenceKnowsClosedForms)
{
    const Shape square = ConvexPolygon({Vector2(-1, -1), Vector2(1, -1), Vector2(1, 1), Vector2(-1, 1)});
    const Pose<2> turned{Vector2(1.75, 0), Rotation<2>(0.25)};
    expectDepth(0.25L, square, square, {Vector2(1.75, 0.5), {}});
    expectDepth(-5, square, square, {Vector2(5, 6), {}});
    expectDepth(-0.5L, square, Circle(0.5), {Vector2(2, 0), {}});
    expectDepth(1 - std::sqrt(2.0L), square, Circle(1), {Vector2(1 + 1, 1 + 1), {}});
    expectDepth(1.125L, Ellipse(1, 0.5), Ellipse(0.125, 3), {});
    expectDepth(1.5L, Ellipse(1, 1), Ellipse(0.5, 0.5), {});
    expectDepth(-0.25L, Circle(1), Ellipse(1, 0.5), {Vector2(2.25, 0), {}});
    // The placed square's corner is where the pose's own cosine and sine put it.
    const Vector2 axis = turned.rotation.apply(Vector2(1, 0));
    const long double corner = 1.75L - static_cast<long double>(axis.x()) - axis.y();
    const PreciseDepth depth = preciseDepth(square, Pose<2>{}, square, turned);
    EXPECT_LT(std::abs(depth.highest - (1 - corner)), 2e-17L);
}

TEST(RobustPairs, referenceAgreesWithASweepOverTheAngle)
{
    RandomSource random(312);
    for (int i = 0; i < 40; ++i)
    {
        const PolyBezier a(anySegments(random));
        const PolyBezier b(anySegments(random));
        const Pose<2> poseA = random.pose(1);
        const Pose<2> poseB = random.pose(1);
        const PreciseDepth depth = preciseDepth(a, poseA, b, poseB);
        const long double swept = sweptDepth(placed(a.outline(), poseA), placed(b.outline(), poseB));
        EXPECT_FALSE(depth.unsettled);
        EXPECT_LT(std::abs(depth.highest - swept), 2e-12L) << "pair " << i;
    }
}

TEST(RobustPairs, referenceHoldsForAnyClaimAndDirection)
{
    const GrainPool pool(313, 2);
    const PairMaker maker(pool, 313);
    RandomSource random(313);
    for (int i = 0; i < 4000; ++i)
    {
        const RandomPair pair = maker.make(stratumOf(i), i);
        const PreciseDifference difference(pair.a->precise, pair.poseA, pair.b->precise, pair.poseB);
        const auto any = [&]() { return test::precise(random.direction()); };
        const PreciseDepth one = referenceOf(pair, difference, any());
        const PreciseDepth other = referenceOf(pair, difference, any());
        const PreciseDepth good = referenceOf(pair, difference, one.normal);
        const PreciseDepth along = referenceOf(pair, difference, {1, 0});
        const long double tolerance = 1e-18L * (pair.larger() + std::abs(one.highest));
        for (const PreciseDepth& each : {one, other, good, along})
        {
            ASSERT_LE(each.lowest, one.highest + tolerance) << "pair " << i;
            ASSERT_GE(each.highest, one.lowest - tolerance) << "pair " << i;
        }
        for (int k = 0; k < 20; ++k)
        {
            ASSERT_GE(difference.height(any()), one.lowest - tolerance) << "pair " << i;
        }
    }
}
