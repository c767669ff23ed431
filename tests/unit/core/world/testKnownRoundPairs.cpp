#include "core/world/wallContact.hpp"
#include "unit/core/world/pairFound.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

// Round grains in positions whose contact is known by formula, through pairContact and pairDistance.

using namespace chesil;
using test::expectContact;
using test::expectDepth;
using test::findPair;
using test::PairFound;

namespace
{

constexpr double epsilon = tolerances::epsilon;

const std::vector<Shape>& unitDisks()
{
    static const std::vector<Shape> disks{Circle(1), Ellipse(1, 1)};
    return disks;
}

} // namespace

TEST(KnownRoundPairs, unitDisksFromShallowToDeep)
{
    for (const Shape& a : unitDisks())
    {
        for (const Shape& b : unitDisks())
        {
            for (double wanted = 1e-15; wanted < 1.5; wanted *= 10)
            {
                const double distance = 2 - wanted;
                const double depth = 2 - distance;
                const PairFound found = findPair(a, b, {distance, 0});
                expectContact(found, depth, {1, 0}, 1e-14);
                EXPECT_LT((found.contact.point - Vector2(1 - depth / 2, 0)).norm(), 1e-14);
                for (const double angle : {0.1, 1.5, 3.0, M_PI, -2.0})
                {
                    const Vector2 elsewhere(std::cos(angle), std::sin(angle));
                    expectContact(findPair(a, Pose<2>{}, b, {Vector2(distance, 0), {}}, SearchStart{elsewhere}), depth, {1, 0}, 1e-8);
                }
            }
        }
    }
}

TEST(KnownRoundPairs, unitDisksThatTouch)
{
    for (const Shape& a : unitDisks())
    {
        for (const Shape& b : unitDisks())
        {
            for (const double gap : {0.0, 2 * epsilon, -2 * epsilon})
            {
                const PairFound found = findPair(a, b, {2 + gap, 0});
                expectDepth(found, -gap, 4 * epsilon);
                EXPECT_LT((found.apart.normal - Vector2(1, 0)).norm(), 1e-8);
                EXPECT_NE(found.status, PairStatus::undecided);
                EXPECT_NE(found.status, PairStatus::coarse);
            }
        }
    }
}

TEST(KnownRoundPairs, concentricDisks)
{
    const std::vector<Shape> small{Circle(0.5), Ellipse(0.5, 0.5)};
    for (const Shape& a : unitDisks())
    {
        for (const Shape& b : small)
        {
            expectDepth(findPair(a, b, {0, 0}), 1.5);
            expectDepth(findPair(b, a, {0, 0}), 1.5);
        }
    }
}

TEST(KnownRoundPairs, nearlyConcentricDisks)
{
    const std::vector<Shape> small{Circle(0.5), Ellipse(0.5, 0.5)};
    for (const Shape& a : unitDisks())
    {
        for (const Shape& b : small)
        {
            const double depth = static_cast<double>(1.5L - 1e-8);
            expectContact(findPair(a, b, {1e-8, 0}), depth, {1, 0}, 1e-6);
            for (const double angle : {0.3, 2.0, M_PI, -1.0})
            {
                const Vector2 elsewhere(std::cos(angle), std::sin(angle));
                expectDepth(findPair(a, Pose<2>{}, b, {Vector2(1e-8, 0), {}}, SearchStart{elsewhere}), depth);
            }
        }
    }
}

TEST(KnownRoundPairs, equalEllipsesShiftedAlongTheirLongAxis)
{
    const auto depthOf = [](long double a, long double b, long double shift)
    {
        return static_cast<double>(
            shift >= 2 * (a * a - b * b) / a ? 2 * a - shift
                                             : 2 * b * std::sqrt(1 - shift * shift / (4 * (a * a - b * b))));
    };
    EXPECT_NEAR(depthOf(1000, 1, 1000), 1.73205051889343, 1e-14);
    for (const double a : {1.5, 2.0, 10.0, 100.0, 1000.0})
    {
        for (const double share : {1e-9, 1e-3, 0.3, 0.9, 0.999, 1.0, 1.2, 1.5, 1.9, 1.999, 1.9999995})
        {
            const double shift = share * a;
            const PairFound found = findPair(Ellipse(a, 1), Ellipse(a, 1), {shift, 0});
            SCOPED_TRACE("a " + std::to_string(a) + ", shift " + std::to_string(shift));
            expectDepth(found, depthOf(a, 1, shift), std::max(1e-12, found.size * 1e-15));
            if (a < 50)
            {
                expectDepth(found, depthOf(a, 1, shift));
            }
        }
    }
}

TEST(KnownRoundPairs, coincidentEllipses)
{
    for (const double b : {1.0, 0.999999, 0.5, 0.1, 0.01, 0.001})
    {
        const PairFound found = findPair(Ellipse(1, b), Ellipse(1, b), {0, 0});
        SCOPED_TRACE("b " + std::to_string(b));
        expectDepth(found, 2 * b, std::max(1e-12 * b, 8 * epsilon * 2 * b));
        if (b < 0.9)
        {
            EXPECT_NEAR(std::abs(found.contact.normal.y()), 1, 1e-14);
        }
    }
}

TEST(KnownRoundPairs, anEllipseAndAWall)
{
    test::RandomSource random(701);
    for (int i = 0; i < 500; ++i)
    {
        const double a = random.logUniform(0.5, 2);
        const double b = random.logUniform(0.5, 2);
        const double angle = random.uniform(-M_PI, M_PI);
        const Vector2 normal = random.direction();
        const Vector2 centre(random.uniform(-1, 1), random.uniform(-1, 1));
        const double gap = random.uniform(0, 0.9) * std::min(a, b);
        const PlaneWall<2> wall{"wall", centre - gap * normal, normal};
        const Pose<2> pose{centre, Rotation<2>(angle)};
        const Vector2 inwards = pose.rotation.applyInverse(normal);
        const double depth =
            std::hypot(a * inwards.x(), b * inwards.y()) - (centre - wall.point).dot(normal);
        ContactGeometry<2> contact{};
        SearchStart start;
        ASSERT_TRUE(wallContact(Ellipse(a, b), pose, wall, start, contact));
        EXPECT_NEAR(contact.depth, depth, 1e-14 * std::max(a, b));
        EXPECT_EQ(contact.normal, Vector2(-normal));
        EXPECT_NEAR(wall.distance(contact.point), -contact.depth / 2, 1e-14);
        const PlaneWall<2> away{"away", centre - (std::max(a, b) + 1e-3) * normal, normal};
        EXPECT_FALSE(wallContact(Ellipse(a, b), pose, away, start, contact));
    }
}

TEST(KnownRoundPairs, aSizeRatioOfAMillion)
{
    const double big = 1e6;
    for (const Shape& large : {Shape(Circle(big)), Shape(Ellipse(big, big)), Shape(Ellipse(big, big / 2))})
    {
        for (const Shape& small : {Shape(Circle(1)), Shape(Ellipse(1, 0.5))})
        {
            for (const double wanted : {0.5, 1e-3, 1e-6})
            {
                const double distance = big + 1 - wanted;
                const PairFound found = findPair(large, small, {distance, 0});
                expectDepth(found, big + 1 - distance, 4 * epsilon * big);
                expectDepth(findPair(small, large, {distance, 0}), big + 1 - distance, 4 * epsilon * big);
            }
        }
    }
    const PolyBezier pebble(test::ellipseSegments(8, 1, 1));
    const Pose<2> there{Vector2(big + 1 - 0.25, 0), Rotation<2>(0.2)};
    for (const Shape& large : {Shape(Circle(big)), Shape(PolyBezier(test::ellipseSegments(10, big, big)))})
    {
        expectDepth(
            findPair(large, Pose<2>{}, pebble, there),
            -static_cast<double>(test::preciseDistance(large, Pose<2>{}, pebble, there)),
            4 * epsilon * big);
    }
}

TEST(KnownRoundPairs, randomSmoothPairsAgainstLongDouble)
{
    test::RandomSource random(705);
    const auto grain = [&](int kind) -> Shape
    {
        test::RandomGrainOptions options;
        options.straight = random.integer(0, 2);
        options.nearlyStraight = random.integer(0, 1);
        const double a = random.uniform(0.5, 1.5);
        return kind == 0 ? Shape(Circle(a))
            : kind == 1  ? Shape(Ellipse(a, random.uniform(0.3, 1.5)))
            : kind == 2  ? Shape(test::randomPolyBezier(options, random))
                         : Shape(test::randomPolygon(random.integer(3, 9), 1, random));
    };
    for (int i = 0; i < 400; ++i)
    {
        const Shape a = grain(i % 4);
        const Shape b = grain(i / 4 % 4);
        const Pose<2> poseA = random.pose(1);
        Pose<2> poseB = random.pose(1.5);
        if (i % 3 != 0)
        {
            // Nearly touching.
            const double apart = static_cast<double>(test::preciseDistance(a, poseA, b, poseB, 400));
            poseB.position -= (apart + random.uniform(-0.01, 0.01)) * unit(poseB.position - poseA.position);
        }
        SCOPED_TRACE("pair " + std::to_string(i) + ", kinds " + std::to_string(a.index()) + ' ' + std::to_string(b.index()));
        const double depth = -static_cast<double>(test::preciseDistance(a, poseA, b, poseB));
        expectDepth(findPair(a, poseA, b, poseB), depth);
        expectDepth(findPair(a, poseA, b, poseB, SearchStart{random.direction()}), depth);
    }
}
