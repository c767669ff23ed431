#include "unit/core/world/pairFound.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

// Polybeziers whose segments are known by formula, through pairContact and pairDistance.

using namespace chesil;
using test::expectContact;
using test::expectDepth;
using test::findPair;
using test::PairFound;

namespace
{

constexpr double epsilon = tolerances::epsilon;

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

TEST(KnownBezierPairs, aQuadraticRaisedToACubicIsTheQuadratic)
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

TEST(KnownBezierPairs, towardsAJointBothSegmentsGiveTheJoint)
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

TEST(KnownBezierPairs, repeatedControlPointsAreFiniteAndRight)
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

TEST(KnownBezierPairs, aVerySmallCornerRadius)
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
