#include "coupling/geometry/halfPlane.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;
using namespace chesil::test;

namespace
{

/// A curve above the x axis's line whose height has these Bernstein coefficients.
CubicBezier heights(double d0, double d1, double d2, double d3)
{
    return CubicBezier({Vector2(0, d0), Vector2(1, d1), Vector2(2, d2), Vector2(3, d3)});
}

ParameterRanges partsAbove(const CubicBezier& curve)
{
    return partsInside(curve, 0, 1, curve.start().y(), curve.end().y(), {Vector2(0, 0), Vector2(1, 0)});
}

void expectRange(const ParameterRanges& found, int index, double from, double to)
{
    ASSERT_GT(found.count, index);
    EXPECT_NEAR(found.ranges[index].from, from, 1e-15);
    EXPECT_NEAR(found.ranges[index].to, to, 1e-15);
}

} // namespace

TEST(HalfPlane, cubicsWithoutCubicOrQuadraticTerm)
{
    // Height 16 t(1-t) - 3 and its negative: zeros 1/4 and 3/4; the slope is linear, rising or falling.
    const double a = 16.0 / 3 - 3;
    const ParameterRanges hill = partsAbove(heights(-3, a, a, -3));
    EXPECT_EQ(hill.count, 1);
    expectRange(hill, 0, 0.25, 0.75);
    const ParameterRanges valley = partsAbove(heights(3, -a, -a, 3));
    EXPECT_EQ(valley.count, 2);
    expectRange(valley, 0, 0, 0.25);
    expectRange(valley, 1, 0.75, 1);
    expectRange(partsAbove(heights(-1, 0, 1, 2)), 0, 1.0 / 3, 1);
}

TEST(HalfPlane, slopeWithAVanishingEndCoefficient)
{
    // d3 = d2 or d0 = d1: one root of the slope lies at an end, the other inside, of either sign of d2 - d1.
    for (const double sign : {1.0, -1.0})
    {
        const double depth = 0.5;
        const CubicBezier atEnd = heights(sign * depth, -sign, -sign * 2 / 3.0, -sign * 2 / 3.0);
        const CubicBezier atStart = heights(-sign * 2 / 3.0, -sign * 2 / 3.0, -sign, sign * depth);
        for (const CubicBezier& curve : {atEnd, atStart})
        {
            const ParameterRanges found = partsAbove(curve);
            ASSERT_EQ(found.count, 1);
            const double crossing = found.ranges[0].from == 0 ? found.ranges[0].to : found.ranges[0].from;
            EXPECT_NEAR(curve.at(crossing).y(), 0, 2e-16);
        }
    }
    // Both ends below, the slope's inner root is the only way to see the hill: b < 0, c = 0 and mirrored.
    EXPECT_EQ(partsAbove(heights(-0.1, 1, -0.5, -0.5)).count, 1);
    EXPECT_EQ(partsAbove(heights(-0.5, -0.5, 1, -0.1)).count, 1);
    EXPECT_EQ(partsAbove(heights(0.1, -1, 0.5, 0.5)).count, 2);
    EXPECT_EQ(partsAbove(heights(0.5, 0.5, -1, 0.1)).count, 2);
}

TEST(HalfPlane, threeCrossings)
{
    // (t - 1/8)(t - 1/2)(t - 7/8), not a convex curve's, must be told apart all the same.
    const double c0 = -7.0 / 128, c1 = 39.0 / 64, c2 = -1.5, c3 = 1;
    const ParameterRanges found =
        partsAbove(heights(c0, c0 + c1 / 3, c0 + 2 * c1 / 3 + c2 / 3, c0 + c1 + c2 + c3));
    ASSERT_EQ(found.count, 2);
    expectRange(found, 0, 0.125, 0.5);
    expectRange(found, 1, 0.875, 1);
}

/// Every end of a range that is not the curve's own lies on the line to the rounding of the coordinates.
TEST(HalfPlane, crossingsLieOnTheLine)
{
    RandomSource random(31);
    double worst = 0;
    int crossings = 0;
    const auto check =
        [&](const auto& curve, const ParameterRanges& found, double from, double to, const HalfPlane& plane)
    {
        for (const auto& range : found)
        {
            for (const double t : {range.from, range.to})
            {
                if (t != from && t != to)
                {
                    worst = std::max(worst, std::abs(plane.distance(curve.at(t))));
                    ++crossings;
                }
            }
        }
    };
    for (int i = 0; i < 5000; ++i)
    {
        const HalfPlane plane{random.uniform(0, 1.2) * random.direction(), random.direction()};
        for (const CubicBezier& curve : randomSegments(RandomGrainOptions(), random))
        {
            const double distanceFrom = plane.distance(curve.start());
            const double distanceTo = plane.distance(curve.end());
            check(curve, partsInside(curve, 0, 1, distanceFrom, distanceTo, plane), 0, 1, plane);
        }
        EllipticArc arc;
        arc.axisA = random.uniform(0.1, 1) * random.direction();
        arc.axisB = random.uniform(0.1, 1) * perpendicular(arc.axisA).normalized();
        arc.from = random.uniform(-10, 10);
        arc.to = arc.from + random.uniform(0.1, 2 * M_PI);
        check(arc, partsInside(arc, arc.from, arc.to, plane), arc.from, arc.to, plane);
    }
    EXPECT_GT(crossings, 5000);
    // Angles up to 16 carry a rounding of 2e-15.
    EXPECT_LE(worst, 5e-15);
}

/// Against a scan of the angle.
TEST(HalfPlane, arcsRangesAreTheOnesInside)
{
    RandomSource random(32);
    for (int i = 0; i < 2000; ++i)
    {
        EllipticArc arc;
        arc.centre = random.uniform(0, 1) * random.direction();
        arc.axisA = random.uniform(0.1, 1) * random.direction();
        arc.axisB = random.uniform(0.1, 1) * perpendicular(arc.axisA).normalized();
        arc.from = random.uniform(-10, 10);
        arc.to = arc.from + random.uniform(0.1, 2 * M_PI);
        const HalfPlane plane{random.uniform(0, 1) * random.direction(), random.direction()};
        const ParameterRanges found = partsInside(arc, arc.from, arc.to, plane);
        for (int k = 1; k < 50; ++k)
        {
            const double angle = arc.from + (arc.to - arc.from) * k / 50;
            bool listed = false;
            for (const auto& range : found)
            {
                listed = listed || (angle >= range.from && angle <= range.to);
            }
            const double distance = plane.distance(arc.at(angle));
            if (std::abs(distance) > 1e-13)
            {
                ASSERT_EQ(listed, distance > 0) << i << " " << k;
            }
        }
    }
}
