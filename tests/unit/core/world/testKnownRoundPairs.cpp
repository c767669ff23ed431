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

/// The cubic that is the quadratic with these control points.
CubicBezier raised(const Vector2& a, const Vector2& b, const Vector2& c)
{
    return CubicBezier({a, a + 2 * (b - a) / 3, c + 2 * (b - c) / 3, c});
}

/// Four parabolas with a common tangent where they meet.
std::vector<std::array<Vector2, 3>> parabolas()
{
    return {
        {Vector2(2, 0), Vector2(2, 1), Vector2(0, 1)},
        {Vector2(0, 1), Vector2(-2, 1), Vector2(-2, 0)},
        {Vector2(-2, 0), Vector2(-2, -1), Vector2(0, -1)},
        {Vector2(0, -1), Vector2(2, -1), Vector2(2, 0)}};
}

PolyBezier raisedParabolas()
{
    std::vector<CubicBezier> segments;
    for (const auto& p : parabolas())
    {
        segments.push_back(raised(p[0], p[1], p[2]));
    }
    return PolyBezier(segments);
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

TEST(KnownRoundPairs, aQuadraticRaisedToACubicIsTheQuadratic)
{
    const PolyBezier grain = raisedParabolas();
    const auto reach = [](test::Real angle)
    {
        const test::PrecisePoint n{std::cos(angle), std::sin(angle)};
        test::Real furthest = -INFINITY;
        for (const auto& p : parabolas())
        {
            std::array<test::Real, 3> h;
            for (std::size_t i = 0; i < 3; ++i)
            {
                h[i] = test::preciseDot(n, {p[i].x(), p[i].y()});
            }
            furthest = std::max({furthest, h[0], h[2]});
            const test::Real t = (h[1] - h[0]) / (2 * h[1] - h[0] - h[2]);
            if (t > 0 && t < 1)
            {
                furthest =
                    std::max(furthest, (1 - t) * (1 - t) * h[0] + 2 * t * (1 - t) * h[1] + t * t * h[2]);
            }
        }
        return furthest;
    };
    test::RandomSource random(702);
    int contacts = 0;
    for (int i = 0; i < 100; ++i)
    {
        const double radius = random.uniform(0.3, 1);
        const Vector2 centre = random.uniform(1, 2.8) * random.direction();
        const auto apart = [&](test::Real angle)
        { return std::cos(angle) * centre.x() + std::sin(angle) * centre.y() - reach(angle) - radius; };
        const double distance = static_cast<double>(test::largestOverAngles(apart, 5, 2000));
        SCOPED_TRACE(i);
        const PairFound found = findPair(grain, Circle(radius), centre);
        contacts += found.overlaps() ? 1 : 0;
        expectDepth(found, -distance);
    }
    EXPECT_GT(contacts, 30);
}

TEST(KnownRoundPairs, towardsAJointBothSegmentsGiveTheJoint)
{
    test::RandomSource random(703);
    for (int i = 0; i < 50; ++i)
    {
        test::RandomGrainOptions options;
        options.straight = random.integer(0, 2);
        options.nearlyStraight = random.integer(0, 2);
        const PolyBezier grain = test::randomPolyBezier(options, random);
        const auto& segments = grain.segments();
        for (std::size_t k = 0; k < segments.size(); ++k)
        {
            const CubicBezier& before = segments[k];
            const CubicBezier& after = segments[(k + 1) % segments.size()];
            const Vector2 joint = after.start();
            const Vector2 normal = unit(-perpendicular(after.startTangent()));
            const test::PrecisePoint n{normal.x(), normal.y()};
            const auto height = [&](const Vector2& p)
            { return static_cast<double>(test::preciseDot(n, {p.x(), p.y()})); };
            EXPECT_NEAR(height(before.at(before.supportParameter(normal))), height(joint), 4 * epsilon);
            EXPECT_NEAR(height(after.at(after.supportParameter(normal))), height(joint), 4 * epsilon);
            EXPECT_NEAR(height(before.curvedSupport(normal).point), height(joint), 4 * epsilon);
            EXPECT_NEAR(height(after.curvedSupport(normal).point), height(joint), 4 * epsilon);
            // A disk before the joint, so that its normal is the contact's. On the core of a convex outline no other
            // valley is as shallow.
            for (const double depth : {-0.1, 1e-9, 1e-3})
            {
                const PairFound found = findPair(grain, Circle(0.25), joint + (0.25 - depth) * normal);
                expectDepth(found, depth);
            }
        }
    }
}

TEST(KnownRoundPairs, repeatedControlPointsAreFiniteAndRight)
{
    // Repeated at the start, at the end, at both; three equal ones make a straight segment.
    const auto quarter = [](const Vector2& start, const Vector2& corner, const Vector2& end, int kind)
    {
        switch (kind)
        {
        case 0:
            return CubicBezier({start, start, corner, end});
        case 1:
            return CubicBezier({start, corner, end, end});
        case 2:
            return CubicBezier({start, corner, corner, end});
        case 3:
            return CubicBezier({start, start, end, end});
        default:
            return CubicBezier({start, start, start, end});
        }
    };
    test::RandomSource random(704);
    for (int kind = 0; kind < 5; ++kind)
    {
        std::vector<CubicBezier> segments;
        const std::vector<Vector2> ends{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        const std::vector<Vector2> corners{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
        for (std::size_t i = 0; i < 4; ++i)
        {
            segments.push_back(quarter(ends[i], corners[i], ends[(i + 1) % 4], kind));
        }
        const PolyBezier grain(segments);
        const std::vector<Shape> others{Circle(0.6), Ellipse(0.7, 0.4), test::rectangle(1, 0.8), grain};
        for (const Shape& other : others)
        {
            for (int i = 0; i < 20; ++i)
            {
                const Pose<2> here{Vector2::Zero(), random.pose(1).rotation};
                const Pose<2> there{random.uniform(0.5, 1.7) * random.direction(), random.pose(1).rotation};
                SCOPED_TRACE("kind " + std::to_string(kind) + ", pair " + std::to_string(i) + ", " + std::to_string(other.index()));
                const PairFound found = findPair(grain, here, other, there);
                expectDepth(found, -static_cast<double>(test::preciseDistance(grain, here, other, there)));
            }
        }
    }
}

TEST(KnownRoundPairs, aVerySmallCornerRadius)
{
    const double r = 1e-6;
    const PolyBezier tile = test::roundedSquare(2, r);
    for (const double wanted : {1e-7, 1e-6, 1e-3, 0.1})
    {
        const double distance = 1 + std::sqrt(2) * (1 - r) + r - wanted;
        const Pose<2> turned{Vector2(distance, 0), Rotation<2>(M_PI / 4)};
        const PairFound found = findPair(tile, Pose<2>{}, tile, turned);
        const double depth = -static_cast<double>(test::preciseDistance(tile, Pose<2>{}, tile, turned));
        EXPECT_NEAR(depth, wanted, 1e-14);
        expectDepth(found, depth, std::max(1e-12 * depth, 8 * epsilon * found.size));
        ASSERT_TRUE(found.overlaps());
        EXPECT_LT((found.contact.normal - Vector2(1, 0)).norm(), 1e-12);
    }
    // Relative to the radius: two such corners tip to tip.
    for (const double share : {1e-3, 0.1, 0.5})
    {
        const double tip = std::sqrt(2) * (1 - r) + r;
        const Pose<2> here{Vector2::Zero(), Rotation<2>(M_PI / 4)};
        const Pose<2> there{Vector2(2 * tip - share * r, 0), Rotation<2>(M_PI / 4)};
        const PairFound found = findPair(tile, here, tile, there);
        expectDepth(found, -static_cast<double>(test::preciseDistance(tile, here, tile, there, 20000)));
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
