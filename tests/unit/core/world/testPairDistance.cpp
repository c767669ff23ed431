#include "core/narrowphase/gjkDistance.hpp"
#include "core/narrowphase/firstNormal.hpp"
#include "unit/core/narrowphase/pairQuery.hpp"
#include "unit/core/world/pairFound.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

// Signed distances: against closed forms, against a sweep over all directions, and GJK's against the valley's.

using namespace chesil;
using test::expectDepth;
using test::findPair;
using test::PairFound;
using test::rectangle;

namespace
{

constexpr double epsilon = tolerances::epsilon;

GjkDistance<2> byGjk(const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB)
{
    return std::visit(
        [&](const auto& shapeA, const auto& shapeB)
        {
            using Difference = MinkowskiDifference<2, std::decay_t<decltype(shapeA)>, std::decay_t<decltype(shapeB)>>;
            const Difference difference(shapeA, poseA, shapeB, poseB);
            return gjkDistance(difference, firstNormal<2>(Vector2::Zero(), difference.centreToCentre()));
        },
        a,
        b);
}

} // namespace

TEST(PairDistance, disks)
{
    test::RandomSource random(731);
    for (int i = 0; i < 2000; ++i)
    {
        const double radiusA = random.logUniform(0.1, 10);
        const double radiusB = random.logUniform(0.1, 10);
        const Pose<2> poseA = random.pose(5);
        const Pose<2> poseB = random.pose(5);
        const Vector2 offset = poseB.position - poseA.position;
        const double distance = static_cast<double>(
            std::hypot(test::Real(offset.x()), test::Real(offset.y())) - radiusA - radiusB);
        const PairFound found = findPair(Circle(radiusA), poseA, Circle(radiusB), poseB);
        expectDepth(found, -distance, found.allowed() + 2 * epsilon * std::abs(distance));
        EXPECT_LT((found.apart.normal - unit(offset)).norm(), 1e-14);
        EXPECT_LT((found.apart.onA - (poseA.position + radiusA * unit(offset))).norm(), 1e-14 * found.size);
        EXPECT_LT((found.apart.onB - (poseB.position - radiusB * unit(offset))).norm(), 1e-13 * (found.size + offset.norm()));
    }
}

TEST(PairDistance, aPointAndASide)
{
    // A disk of hardly any radius beside, and beyond the corner of, a square of side 2.
    const double r = 1e-12;
    for (const Shape& square : {Shape(rectangle(2, 2)), Shape(PolyBezier(test::polygonSegments(test::rectangleVertices(2, 2))))})
    {
        for (const Shape& point : {Shape(Circle(r)), Shape(Ellipse(r, r))})
        {
            const PairFound beside = findPair(square, point, {1.5, 0.3});
            expectDepth(beside, r - 0.5);
            EXPECT_LT((beside.apart.onA - Vector2(1, 0.3)).norm(), 1e-14);
            EXPECT_LT((beside.apart.onB - Vector2(1.5, 0.3)).norm(), 2 * r);
            const PairFound beyond = findPair(square, point, {1.3, 1.4});
            expectDepth(beyond, r - 0.5);
            EXPECT_LT((beyond.apart.onA - Vector2(1, 1)).norm(), 1e-14);
            EXPECT_LT((beyond.apart.normal - Vector2(0.6, 0.8)).norm(), 1e-14);
            // On the border between side and corner.
            expectDepth(findPair(square, point, {1.5, 1}), r - 0.5);
            expectDepth(findPair(point, square, {1.5, 1}), r - 0.5);
        }
    }
}

TEST(PairDistance, cornerToCorner)
{
    test::RandomSource random(732);
    const std::vector<Shape> squares{
        rectangle(2, 2), PolyBezier(test::polygonSegments(test::rectangleVertices(2, 2)))};
    for (const Shape& a : squares)
    {
        for (const Shape& b : squares)
        {
            for (const double gap : {1e-9, 1e-3, 1.0, 1e3})
            {
                const PairFound found = findPair(a, b, {2 + gap, 2 + gap});
                expectDepth(found, -static_cast<double>(((2 + gap) - 2) * std::sqrt(2.0L)), found.allowed() + epsilon * gap);
                EXPECT_LT((found.apart.onA - Vector2(1, 1)).norm(), 1e-14);
            }
        }
    }
}

TEST(PairDistance, ellipsesAgainstASweep)
{
    test::RandomSource random(733);
    for (int i = 0; i < 300; ++i)
    {
        const Ellipse a(random.logUniform(0.1, 2), random.logUniform(0.1, 2));
        const Ellipse b(random.logUniform(0.1, 2), random.logUniform(0.1, 2));
        const Pose<2> poseA = random.pose(1);
        const Pose<2> poseB = random.pose(5);
        SCOPED_TRACE(i);
        const PairFound found = findPair(a, poseA, b, poseB);
        const double distance = static_cast<double>(test::preciseDistance(a, poseA, b, poseB));
        expectDepth(found, -distance, found.allowed() + 2 * epsilon * std::abs(distance));
        test::expectWitnesses(found, a, poseA, b, poseB);
    }
}

TEST(PairDistance, witnessesOfAllKindsLieOnTheOutlines)
{
    test::RandomSource random(734);
    for (int i = 0; i < 320; ++i)
    {
        const Shape a = test::grainOfKind(i % 4, random);
        const Shape b = test::grainOfKind(i / 4 % 4, random);
        const Pose<2> poseA = random.pose(1);
        Pose<2> poseB = random.pose(4);
        if (i % 3 == 0)
        {
            const double apart = static_cast<double>(test::preciseDistance(a, poseA, b, poseB, 400));
            poseB.position -= (apart + random.uniform(-0.1, 0.1)) * unit(poseB.position - poseA.position);
        }
        SCOPED_TRACE("pair " + std::to_string(i) + ", kinds " + std::to_string(a.index()) + ' ' + std::to_string(b.index()));
        const PairFound found = findPair(a, poseA, b, poseB);
        const double distance = static_cast<double>(test::preciseDistance(a, poseA, b, poseB));
        expectDepth(found, -distance, found.allowed() + 2 * epsilon * std::abs(distance));
        test::expectWitnesses(found, a, poseA, b, poseB);
    }
}

TEST(PairDistance, gjkAgreesToItsTolerance)
{
    test::RandomSource random(735);
    int apart = 0;
    for (int i = 0; i < 4000; ++i)
    {
        const Shape a = test::grainOfKind(i % 4, random);
        const Shape b = test::grainOfKind(i / 4 % 4, random);
        const Pose<2> poseA = random.pose(1);
        const Pose<2> poseB = random.pose(4);
        const PairFound found = findPair(a, poseA, b, poseB);
        const GjkDistance<2> gjk = byGjk(a, poseA, b, poseB);
        const double allowed = (tolerances::expandingPolytope + tolerances::supportRounding) * found.size;
        SCOPED_TRACE("pair " + std::to_string(i) + ", kinds " + std::to_string(a.index()) + ' ' + std::to_string(b.index()));
        if (std::abs(found.apart.distance) <= allowed)
        {
            continue;
        }
        ASSERT_EQ(gjk.status, found.apart.distance > 0 ? GjkStatus::separated : GjkStatus::overlapping);
        if (gjk.status == GjkStatus::separated)
        {
            ++apart;
            EXPECT_NEAR(gjk.distance, found.apart.distance, allowed);
            EXPECT_GE(gjk.distance, found.apart.distance - found.allowed()) << "from outside";
            EXPECT_LT((gjk.onB - gjk.onA - gjk.distance * gjk.normal).norm(), 8 * epsilon * (found.size + gjk.distance));
            // The nearest point turns by the root of the tolerance.
            EXPECT_LT((gjk.normal - found.apart.normal).norm(), 2 * std::sqrt(2 * allowed / found.apart.distance));
        }
    }
    EXPECT_GT(apart, 1000);
}

TEST(PairDistance, farPairs)
{
    test::RandomSource random(736);
    for (int i = 0; i < 160; ++i)
    {
        const Shape a = test::grainOfKind(i % 4, random);
        const Shape b = test::grainOfKind(i / 4 % 4, random);
        const Pose<2> poseA = random.pose(1);
        const double far = i % 2 == 0 ? 1e6 : 1e3;
        const Pose<2> poseB{poseA.position + far * random.direction(), random.pose(1).rotation};
        SCOPED_TRACE("pair " + std::to_string(i) + ", kinds " + std::to_string(a.index()) + ' ' + std::to_string(b.index()));
        const PairFound found = findPair(a, poseA, b, poseB);
        EXPECT_EQ(found.status, PairStatus::separated);
        EXPECT_EQ(found.apart.status, PairStatus::separated);
        const double distance = static_cast<double>(test::preciseDistance(a, poseA, b, poseB, 4000));
        EXPECT_NEAR(found.apart.distance, distance, 4 * epsilon * far);
        EXPECT_LT(((found.apart.onB - found.apart.onA) - found.apart.distance * found.apart.normal).norm(), 4 * epsilon * far);
        // Along the right direction to the rounding of the positions.
        EXPECT_NEAR(static_cast<double>(test::preciseDistance(a, poseA, found.apart.onA)), 0, 4 * epsilon * found.size);
        const GjkDistance<2> gjk = byGjk(a, poseA, b, poseB);
        EXPECT_EQ(gjk.status, GjkStatus::separated);
        EXPECT_NEAR(gjk.distance, distance, 2e-12 * found.size + 4 * epsilon * far);
    }
}

TEST(PairDistance, aDirectionToStartFromChangesNothing)
{
    test::RandomSource random(737);
    for (int i = 0; i < 2000; ++i)
    {
        const Shape a = test::grainOfKind(i % 4, random);
        const Shape b = test::grainOfKind(i / 4 % 4, random);
        const Pose<2> poseA = random.pose(1);
        const Pose<2> poseB = random.pose(4);
        SCOPED_TRACE("pair " + std::to_string(i) + ", kinds " + std::to_string(a.index()) + ' ' + std::to_string(b.index()));
        const PairFound found = findPair(a, poseA, b, poseB);
        const PairDistance other = pairDistance(a, poseA, b, poseB, random.uniform(0.1, 10) * random.direction());
        ASSERT_EQ(found.apart.status, other.status);
        EXPECT_NEAR(found.apart.distance, other.distance, 2 * found.allowed());
    }
}
