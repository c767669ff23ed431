#include "core/shapes/circle.hpp"
#include "core/shapes/ellipse.hpp"
#include "unit/core/narrowphase/pairQuery.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;
using test::query;
using test::RandomSource;

namespace
{

/// The sweep's own error, and a verdict's, are roundings of a support difference.
constexpr double rounding = 4 * tolerances::supportRounding;

PolyBezier pebble(RandomSource& random)
{
    test::RandomGrainOptions options;
    options.straight = random.integer(0, 1);
    options.nearlyStraight = random.integer(0, 1);
    return test::randomPolyBezier(options, random);
}

Ellipse egg(RandomSource& random)
{
    const double a = random.uniform(0.5, 1.5);
    return Ellipse(a, random.uniform(0.3, 1.5));
}

ConvexPolygon tile(RandomSource& random) { return test::randomPolygon(random.integer(3, 9), 1, random); }

/// Against the sweep, against B and A swapped, and against a start in another direction.
template <class ShapeA, class ShapeB>
void expectRight(const ShapeA& a, const Pose<2>& poseA, const ShapeB& b, const Pose<2>& poseB,
                 RandomSource& random)
{
    const double separation = test::SeparationSweep<ShapeA, ShapeB>(a, poseA, b, poseB).largest();
    const test::PairAnswer answer = query(a, poseA, b, poseB);
    const test::PairAnswer swapped = query(b, poseB, a, poseA);
    const test::PairAnswer elsewhere = query(a, poseA, b, poseB, random.direction());
    const double size = answer.size;
    for (const test::PairAnswer& each : {answer, swapped, elsewhere})
    {
        ASSERT_NE(each.status, GjkStatus::iterationLimit);
        ASSERT_NE(each.status, GjkStatus::notFinite);
        if (std::abs(separation) > rounding * size)
        {
            ASSERT_EQ(each.overlaps(), separation < 0) << "separation " << separation;
        }
        ASSERT_NEAR(each.depth, std::max(0.0, -separation), each.depthError + rounding * size);
    }
    if (separation < -1e-3 * size)
    {
        // The depth is that along the normal, whether or not another valley is as deep; each is mirrored.
        const MinkowskiDifference<2, ShapeA, ShapeB> difference(a, poseA, b, poseB);
        EXPECT_NEAR(difference.support(answer.normal).difference.dot(answer.normal), answer.depth,
                    rounding * size);
        EXPECT_NEAR(difference.support(-swapped.normal).difference.dot(-swapped.normal), swapped.depth,
                    rounding * size);
        // The contact point is half way between the two surfaces.
        const Vector2 deepest = a.support(poseA.rotation.applyInverse(answer.normal));
        const double onA = poseA.toWorld(deepest).dot(answer.normal);
        EXPECT_NEAR(answer.point.dot(answer.normal), onA - answer.depth / 2,
                    answer.depthError + rounding * size);
    }
}

/// Half of the pairs anywhere near, half at most a hundredth deep or apart.
template <class MakeA, class MakeB>
void runPairs(const MakeA& makeA, const MakeB& makeB, std::uint64_t seed)
{
    constexpr int pairs = 60;
    RandomSource random(seed);
    for (int i = 0; i < pairs && !testing::Test::HasFatalFailure(); ++i)
    {
        const auto a = makeA(random);
        const auto b = makeB(random);
        const Pose<2> poseA = random.pose(1);
        Pose<2> poseB = random.pose(1.5);
        if (i % 2 == 1)
        {
            const double shift = test::SeparationSweep(a, poseA, b, poseB).largest(500);
            const Vector2 away = poseB.position - poseA.position;
            poseB.position -= (shift + random.uniform(-0.01, 0.01)) * away.normalized();
        }
        SCOPED_TRACE("pair " + std::to_string(i) + " of seed " + std::to_string(seed));
        expectRight(a, poseA, b, poseB, random);
    }
}

} // namespace

TEST(RandomPairs, pebblesAndPebbles) { runPairs(pebble, pebble, 91); }
TEST(RandomPairs, pebblesAndEggs) { runPairs(pebble, egg, 92); }
TEST(RandomPairs, pebblesAndTiles) { runPairs(pebble, tile, 93); }
TEST(RandomPairs, eggsAndEggs) { runPairs(egg, egg, 94); }
TEST(RandomPairs, eggsAndTiles) { runPairs(egg, tile, 95); }
TEST(RandomPairs, tilesAndTiles) { runPairs(tile, tile, 96); }

TEST(RandomPairs, circlesByFormula)
{
    RandomSource random(97);
    for (int i = 0; i < 2000; ++i)
    {
        const double radius = random.logUniform(0.1, 10);
        const Circle a(radius);
        const Circle b(random.logUniform(0.1, 10));
        const Pose<2> poseA = random.pose(5);
        const Pose<2> poseB = random.pose(5);
        const double depth = a.radius() + b.radius() - (poseA.position - poseB.position).norm();
        const test::PairAnswer answer = query(a, poseA, b, poseB);
        ASSERT_EQ(answer.overlaps(), depth > 0) << depth;
        ASSERT_NEAR(answer.depth, std::max(depth, 0.0), answer.depthError);
    }
}

TEST(RandomPairs, turnedTogetherTheDepthStays)
{
    RandomSource random(98);
    for (int i = 0; i < 200; ++i)
    {
        const PolyBezier a = pebble(random);
        const PolyBezier b = pebble(random);
        const Pose<2> poseA = random.pose(0.5);
        const Pose<2> poseB = random.pose(0.5);
        const Rotation<2> turn(random.uniform(-M_PI, M_PI));
        const auto turned = [&](const Pose<2>& pose) {
            return Pose<2>{turn.apply(pose.position), Rotation<2>(pose.rotation.angle() + turn.angle())};
        };
        const test::PairAnswer one = query(a, poseA, b, poseB);
        const test::PairAnswer other = query(a, turned(poseA), b, turned(poseB));
        ASSERT_EQ(one.overlaps(), other.overlaps());
        EXPECT_NEAR(one.depth, other.depth, one.depthError + other.depthError + rounding * one.size);
    }
}

TEST(RandomPairs, rollingSmoothlyAndWarmAsCold)
{
    // A grain on its way over another one: from step to step the depth changes by no more than the motion.
    RandomSource random(99);
    const PolyBezier a = pebble(random);
    const PolyBezier b = pebble(random);
    constexpr int steps = 10000;
    const double reach = 0.9 * (a.boundingRadius() + b.boundingRadius());
    const double motion = reach * 2 * M_PI / steps + b.boundingRadius() * 4 * M_PI / steps;
    Vector2 direction(1, 0);
    double last = -1;
    int contacts = 0;
    for (int i = 0; i < steps; ++i)
    {
        const double angle = 2 * M_PI * i / steps;
        const Pose<2> pose{0.8 * reach * Vector2(std::cos(angle), std::sin(angle)), Rotation<2>(2 * angle)};
        const test::PairAnswer warm = query(a, Pose<2>{}, b, pose, direction);
        const test::PairAnswer cold = query(a, Pose<2>{}, b, pose);
        ASSERT_EQ(warm.overlaps(), cold.overlaps()) << i;
        ASSERT_NEAR(warm.depth, cold.depth, warm.depthError + cold.depthError) << i;
        if (last >= 0)
        {
            ASSERT_LT(std::abs(warm.depth - last), motion + 2 * warm.depthError) << i;
        }
        last = warm.depth;
        direction = warm.overlaps() ? warm.normal : direction;
        contacts += warm.overlaps() ? 1 : 0;
    }
    EXPECT_GT(contacts, steps / 10);
}
