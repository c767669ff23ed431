#include "core/shapes/circle.hpp"
#include "core/shapes/ellipse.hpp"
#include "unit/core/narrowphase/pairQuery.hpp"
#include "unit/knownShapes.hpp"

#include <gtest/gtest.h>

// Round shapes in positions whose depth is known by formula. The normal of a smooth contact is right within
// sqrt(2 depthError/D), D the distance of the centres of curvature: the depth is at its least there, hence
// flat.

using namespace chesil;
using test::query;

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

} // namespace

TEST(KnownRoundContacts, unitCircles)
{
    const Circle circle(1);
    for (double wanted = 1e-14; wanted < 1.5; wanted *= 10)
    {
        const double distance = 2 - wanted;
        const double depth = 2 - distance;
        const test::PairAnswer answer = query(circle, circle, {distance, 0});
        ASSERT_TRUE(answer.overlaps()) << wanted;
        EXPECT_NEAR(answer.depth, depth, answer.depthError) << wanted;
        EXPECT_GE(answer.depth, depth - 4 * epsilon);
        EXPECT_NEAR(answer.normal.norm(), 1, 2 * epsilon);
        EXPECT_LT((answer.normal - Vector2(1, 0)).norm(), std::sqrt(2 * answer.depthError / distance))
            << wanted;
        EXPECT_LT((answer.point - Vector2(1 - depth / 2, 0)).norm(), 1e-4);
    }
}

TEST(KnownRoundContacts, touchingWithinRounding)
{
    const Circle circle(1);
    for (const double gap : {0.0, 4e-16, -4e-16, 2e-15, -2e-15})
    {
        const test::PairAnswer answer = query(circle, circle, {2 + gap, 0});
        EXPECT_NE(answer.status, GjkStatus::iterationLimit);
        EXPECT_LE(answer.depth, answer.depthError) << gap;
    }
    EXPECT_EQ(query(circle, circle, {2, 0}).depth, 0);
    EXPECT_EQ(query(circle, circle, {2 + 1e-14, 0}).status, GjkStatus::separated);
}

TEST(KnownRoundContacts, concentricCircles)
{
    // Every normal is right: EPA may fill its polytope, but any support point has the depth.
    const test::PairAnswer answer = query(Circle(1), Circle(0.5), {0, 0});
    ASSERT_TRUE(answer.overlaps());
    EXPECT_NEAR(answer.depth, 1.5, 4 * epsilon);
    EXPECT_NEAR(answer.normal.norm(), 1, 2 * epsilon);
}

TEST(KnownRoundContacts, nearlyConcentricCircles)
{
    const test::PairAnswer answer = query(Circle(1), Circle(0.5), {1e-8, 0});
    ASSERT_TRUE(answer.overlaps());
    // Whatever the normal: 1.5 - 1e-8 cos(angle) is within the promise of 1.5 - 1e-8 and the centres' offset.
    EXPECT_NEAR(answer.depth, 1.5 - 1e-8, 2e-8);
}

TEST(KnownRoundContacts, equalAlignedEllipsesShiftedAlongTheirLongAxis)
{
    const auto depthOf = [](double a, double b, double shift)
    {
        return shift >= 2 * (a * a - b * b) / a
                   ? 2 * a - shift
                   : 2 * b * std::sqrt(1 - shift * shift / (4 * (a * a - b * b)));
    };
    EXPECT_NEAR(depthOf(1000, 1, 1000), 1.73205051889343, 1e-13);
    struct Case
    {
        double a, b, shift;
    };
    for (const Case& c : {Case{2, 1, 3.5}, Case{2, 1, 2.5}, Case{2, 1, 1}, Case{10, 1, 10}, Case{100, 1, 100},
                          Case{1000, 1, 1000}})
    {
        const Ellipse ellipse(c.a, c.b);
        const test::PairAnswer answer = query(ellipse, ellipse, {c.shift, 0});
        ASSERT_TRUE(answer.overlaps());
        EXPECT_EQ(answer.epaStatus, EpaStatus::converged);
        EXPECT_NEAR(answer.depth, depthOf(c.a, c.b, c.shift), answer.depthError) << c.a << ' ' << c.shift;
    }
}

TEST(KnownRoundContacts, coincidentEllipses)
{
    const Ellipse ellipse(3, 0.5);
    const test::PairAnswer answer = query(ellipse, ellipse, {0, 0});
    ASSERT_TRUE(answer.overlaps());
    EXPECT_NEAR(answer.depth, 1, answer.depthError);
    EXPECT_NEAR(std::abs(answer.normal.y()), 1, 1e-8);
}

TEST(KnownRoundContacts, roundedSquaresFaceToFace)
{
    const PolyBezier tile = test::roundedSquare(2, 0.25);
    for (const double depth : {1e-9, 1e-4, 0.1})
    {
        const test::PairAnswer answer = query(tile, tile, {0, 2 - depth});
        ASSERT_TRUE(answer.overlaps());
        EXPECT_NEAR(answer.depth, depth, answer.depthError);
        EXPECT_LT((answer.normal - Vector2(0, 1)).norm(), 1e-4);
    }
}

TEST(KnownRoundContacts, aVerySmallCornerRadius)
{
    // Rounded corner of radius r of a turned square in the flat of another one: its tip is at half diagonal
    // of the inner square + r (1 + the error of a cubic quarter circle at its middle: none).
    const double r = 1e-6;
    const PolyBezier tile = test::roundedSquare(2, r);
    const double tip = std::sqrt(2) * (1 - r) + r;
    const test::PairAnswer answer = query(tile, tile, {1 + tip - 1e-3, 0}, M_PI / 4);
    ASSERT_TRUE(answer.overlaps());
    EXPECT_NEAR(answer.depth, 1e-3, answer.depthError);
}

TEST(KnownRoundContacts, aSizeRatioOfAMillion)
{
    // Error relative to the *sum* of the radii: what the present kernel promises.
    const Ellipse large(1e6, 1e6);
    const Ellipse small(1, 1);
    const test::PairAnswer answer = query(large, small, {1e6 + 1 - 0.125, 0});
    ASSERT_TRUE(answer.overlaps());
    EXPECT_NEAR(answer.depth, 0.125, answer.depthError);
}

TEST(KnownRoundContacts, farFromTheOrigin)
{
    const Ellipse a(2, 1);
    const PolyBezier b(test::ellipseSegments(8, 1, 1.5));
    const Vector2 offset(2.5, 0.5);
    for (const Vector2& away : {Vector2(1048576, -1048576), Vector2(0, 1073741824.0)})
    {
        const test::PairAnswer near = query(a, Pose<2>{}, b, Pose<2>{offset, Rotation<2>(0.3)});
        const test::PairAnswer far = query(a, Pose<2>{away, {}}, b, Pose<2>{away + offset, Rotation<2>(0.3)});
        ASSERT_TRUE(near.overlaps());
        // The offset is exact in both: so is everything but the contact point.
        EXPECT_EQ(near.depth, far.depth);
        EXPECT_EQ(near.normal, far.normal);
        EXPECT_LT((near.point + away - far.point).norm(), epsilon * away.norm());
    }
}

TEST(KnownRoundContacts, scaledByPowersOfTwoTheSameBits)
{
    const auto segments = test::ellipseSegments(8, 1, 1.5);
    const test::PairAnswer one = query(Ellipse(2, 1), PolyBezier(segments), {2.5, 0.5}, 0.3);
    ASSERT_TRUE(one.overlaps());
    for (const double scale : {std::ldexp(1, 20), std::ldexp(1, -20), std::ldexp(1, -40)})
    {
        std::vector<CubicBezier> scaled;
        for (const CubicBezier& segment : segments)
        {
            scaled.push_back(segment.transformed(Vector2::Zero(), 1, 0, scale));
        }
        const test::PairAnswer other =
            query(Ellipse(2 * scale, scale), PolyBezier(scaled), scale * Vector2(2.5, 0.5), 0.3);
        EXPECT_EQ(one.depth * scale, other.depth);
        EXPECT_EQ(one.normal, other.normal);
        EXPECT_EQ(one.point * scale, other.point);
    }
    for (const double scale : {1e-6, 1e6})
    {
        const test::PairAnswer other =
            query(Ellipse(2 * scale, scale), Ellipse(scale, 1.5 * scale), scale * Vector2(2.5, 0.5), 0.3);
        const test::PairAnswer unit = query(Ellipse(2, 1), Ellipse(1, 1.5), {2.5, 0.5}, 0.3);
        EXPECT_NEAR(other.depth / scale, unit.depth, 2 * unit.depthError);
    }
}

TEST(KnownRoundContacts, notANumberHasAStatus)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Circle a(1);
    const PolyBezier b(test::ellipseSegments(8, 1, 1));
    EXPECT_EQ(query(a, Pose<2>{}, b, Pose<2>{Vector2(nan, 0), {}}).status, GjkStatus::notFinite);
    EXPECT_EQ(query(a, Pose<2>{}, b, Pose<2>{Vector2(1, 0), Rotation<2>(nan)}).status, GjkStatus::notFinite);
    EXPECT_EQ(query(b, Pose<2>{Vector2(0, INFINITY), {}}, a, Pose<2>{}).status, GjkStatus::notFinite);
}
