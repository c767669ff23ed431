#include "core/geometry/cubicBezier.hpp"

#include "unit/preciseCurve.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Points of a segment of size 1 carry some roundings of their control points' size.
constexpr double rounding = 16 * epsilon;

CubicBezier randomSegment(test::RandomSource& random)
{
    std::array<Vector2, 4> points;
    for (Vector2& point : points)
    {
        const double x = random.uniform(-1, 1);
        point = Vector2(x, random.uniform(-1, 1));
    }
    return CubicBezier(points);
}

/// y = x^2 between x0 and x1: a quadratic Bezier segment raised to a cubic one (its t^3 terms vanish).
CubicBezier parabola(double x0, double x1)
{
    const Vector2 start(x0, x0 * x0);
    const Vector2 end(x1, x1 * x1);
    const Vector2 crossing((x0 + x1) / 2, x0 * x1);
    return CubicBezier({start, start + 2.0 / 3 * (crossing - start), end + 2.0 / 3 * (crossing - end), end});
}

} // namespace

TEST(CubicBezier, pointAndDerivativesAgreeWithTheSumOfPowers)
{
    test::RandomSource random(11);
    for (int trial = 0; trial < 200; ++trial)
    {
        const CubicBezier segment = randomSegment(random);
        const double t = random.uniform(0, 1);
        const auto& p = segment.controlPoints();
        const Vector2 c1 = 3 * (p[1] - p[0]);
        const Vector2 c2 = 3 * (p[0] - 2 * p[1] + p[2]);
        const Vector2 c3 = p[3] - p[0] + 3 * (p[1] - p[2]);
        EXPECT_LT((segment.at(t) - (p[0] + t * (c1 + t * (c2 + t * c3)))).norm(), rounding);
        EXPECT_LT((segment.derivative(t) - (c1 + t * (2 * c2 + 3 * t * c3))).norm(), 8 * rounding);
        EXPECT_LT((segment.secondDerivative(t) - (2 * c2 + 6 * t * c3)).norm(), 8 * rounding);
        EXPECT_EQ(segment.at(0), p[0]);
        EXPECT_EQ(segment.at(1), p[3]);
    }
}

TEST(CubicBezier, partsRunAlongTheWhole)
{
    test::RandomSource random(12);
    for (int trial = 0; trial < 200; ++trial)
    {
        const CubicBezier segment = randomSegment(random);
        const double t0 = trial % 5 == 0 ? 0 : random.uniform(0, 0.9);
        const double t1 = trial % 7 == 0 ? 1 : random.uniform(t0, 1);
        const CubicBezier part = segment.part(t0, t1);
        const auto [left, right] = segment.split(t1);
        EXPECT_EQ(left.end(), right.start());
        EXPECT_EQ(left.start(), segment.start());
        EXPECT_EQ(right.end(), segment.end());
        for (const double s : {0.0, 0.2, 0.5, 1.0})
        {
            EXPECT_LT((part.at(s) - segment.at(t0 + s * (t1 - t0))).norm(), rounding);
            EXPECT_LT((left.at(s) - segment.at(s * t1)).norm(), rounding);
            EXPECT_LT((right.at(s) - segment.at(t1 + s * (1 - t1))).norm(), rounding);
        }
    }
}

TEST(CubicBezier, curvatureOfAParabolaIsExact)
{
    for (const auto& [x0, x1] : {std::pair{-1.0, 2.0}, std::pair{0.0, 0.5}, std::pair{-0.1, 0.1}})
    {
        const CubicBezier segment = parabola(x0, x1);
        for (double t = 0; t <= 1; t += 0.125)
        {
            const double x = x0 + t * (x1 - x0);
            const double expected = std::pow(1 + 4 * x * x, 1.5) / 2;
            EXPECT_NEAR(segment.curvatureRadius(t) / expected, 1, 1e3 * rounding) << "x = " << x;
            // Run through backwards it turns clockwise.
            const auto& p = segment.controlPoints();
            EXPECT_LT(CubicBezier({p[3], p[2], p[1], p[0]}).curvatureRadius(t), 0);
        }
    }
}

TEST(CubicBezier, straightSegmentHasNoCurvature)
{
    const CubicBezier segment = CubicBezier::straight({0, 0}, {3, 0});
    EXPECT_EQ(segment.curvatureRadius(0.3), std::numeric_limits<double>::infinity());
    EXPECT_LT((segment.derivative(0.7) - Vector2(3, 0)).norm(), rounding);
}

TEST(CubicBezier, tangentsSkipRepeatedControlPoints)
{
    const Vector2 a(0, 0);
    const Vector2 b(1, 0);
    const Vector2 c(1, 1);
    EXPECT_EQ(CubicBezier({a, a, b, c}).startTangent(), b - a);
    EXPECT_EQ(CubicBezier({a, a, a, c}).startTangent(), c - a);
    EXPECT_EQ(CubicBezier({a, b, c, c}).endTangent(), c - b);
    EXPECT_EQ(CubicBezier({a, c, c, c}).endTangent(), c - a);
    EXPECT_EQ(CubicBezier({a, a, a, a}).startTangent(), Vector2::Zero());
    EXPECT_EQ(CubicBezier({a, a, a, a}).endTangent(), Vector2::Zero());
}

TEST(CubicBezier, supportParameterOfARaisedQuadraticIsTheQuadratics)
{
    // Where the slope of y = x^2 is 2x = s, the outward normal (downwards) is (s, -1).
    const CubicBezier segment = parabola(-1, 2);
    for (double x = -1; x <= 2; x += 0.0625)
    {
        EXPECT_NEAR(segment.supportParameter(Vector2(2 * x, -1)), (x + 1) / 3, rounding);
        EXPECT_NEAR(segment.supportParameter(1e-9 * Vector2(2 * x, -1)), (x + 1) / 3, rounding);
    }
}

TEST(CubicBezier, supportParameterOfAStraightSegmentIsAnEndOrTheMiddle)
{
    const CubicBezier segment = CubicBezier::straight({0, 0}, {3, 0});
    EXPECT_EQ(segment.supportParameter({0, -1}), 0.5);
    EXPECT_EQ(segment.supportParameter({1e-12, -1}), 1);
    EXPECT_EQ(segment.supportParameter({-1e-12, -1}), 0);
}

TEST(CubicBezier, supportParameterAlongAStraightSegmentsNormalIsFinite)
{
    // Rounding leaves each of the three rises 0 or something of either sign: all combinations occur.
    test::RandomSource random(14);
    for (int trial = 0; trial < 200000; ++trial)
    {
        const Vector2 start = random.direction();
        const Vector2 edge = random.logUniform(1e-6, 1) * random.direction();
        const CubicBezier segment = CubicBezier::straight(start, start + edge);
        const double t =
            segment.supportParameter(-perpendicular(segment.end() - segment.start()).normalized());
        ASSERT_TRUE(t >= 0 && t <= 1) << t << " in trial " << trial;
    }
    const Vector2 right(1, 0);
    for (const double x : {-1.0, 0.0, 1.0})
    {
        for (const double y : {-1.0, 0.0, 1.0})
        {
            for (const double z : {-1.0, 0.0, 1.0})
            {
                const Vector2 p0(0, 0);
                const Vector2 p1(x * 1e-300, 1);
                const Vector2 p2(p1 + Vector2(y * 1e-300, 1));
                const Vector2 p3(p2 + Vector2(z * 1e-300, 1));
                const double t = CubicBezier({p0, p1, p2, p3}).supportParameter(right);
                EXPECT_TRUE(t >= 0 && t <= 1) << t << " for rises " << x << ' ' << y << ' ' << z;
            }
        }
    }
}

TEST(CubicBezier, supportParameterOutsideTheNormalRangeIsTheNearerEnd)
{
    // Turns from 0 to 170 degrees: normals from -90 to 80 degrees. With an end that turns this far, a
    // direction beyond the normal range of one end sees the first control edge from behind, too.
    const double turn = 170 * M_PI / 180;
    const Vector2 end = Vector2(1.1, 0) + 0.5 * Vector2(std::cos(turn), std::sin(turn));
    const CubicBezier segment({Vector2(0, 0), Vector2(1, 0), Vector2(1.1, 0), end});
    for (const double beyond : {1e-9, 1.0, 8.0, 12.0, 17.0})
    {
        const double after = (80 + beyond) * M_PI / 180;
        EXPECT_EQ(segment.supportParameter({std::cos(after), std::sin(after)}), 1) << beyond << " degrees";
        const double before = (-90 - beyond) * M_PI / 180;
        EXPECT_EQ(segment.supportParameter({std::cos(before), std::sin(before)}), 0) << beyond << " degrees";
    }
}

TEST(CubicBezier, transformedMovesEveryPoint)
{
    test::RandomSource random(13);
    const CubicBezier segment = randomSegment(random);
    const CubicBezier moved = segment.transformed({3, 4}, 0, 1, 2);
    for (double t = 0; t <= 1; t += 0.25)
    {
        EXPECT_LT((moved.at(t) - (Vector2(3, 4) + 2 * perpendicular(segment.at(t)))).norm(), 8 * rounding);
    }
}
