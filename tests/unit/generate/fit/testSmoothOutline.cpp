#include "generate/fit/smoothOutline.hpp"

#include "core/base/setupError.hpp"
#include "core/base/tolerances.hpp"
#include "core/shapes/polyBezier.hpp"
#include "generate/image/convexHull.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

std::vector<Vector2> ellipsePolygon(double a, double b, double turn, const Vector2& centre, int sides)
{
    const Rotation<2> rotation(turn);
    std::vector<Vector2> polygon;
    for (int i = 0; i < sides; ++i)
    {
        const double angle = 2 * M_PI * i / sides;
        polygon.push_back(centre + rotation.apply(Vector2(a * std::cos(angle), b * std::sin(angle))));
    }
    return polygon;
}

double relativeAreaError(const std::vector<Vector2>& polygon, int segments)
{
    return PolyBezier(fitSmoothOutline(polygon, segments)).massProperties().area / polygonArea(polygon) - 1;
}

} // namespace

TEST(SmoothOutline, ofACircleIsTheCircle)
{
    const std::vector<Vector2> polygon = ellipsePolygon(1, 1, 0, Vector2(3, -2), 2000);
    const PolyBezier grain(fitSmoothOutline(polygon, 10));
    EXPECT_NEAR((grain.givenCentroid() - Vector2(3, -2)).norm(), 0, 1e-6);
    for (int i = 0; i < 1000; ++i)
    {
        const double angle = 2 * M_PI * i / 1000;
        const Vector2 direction(std::cos(angle), std::sin(angle));
        // A cubic arc of 36 degrees leaves the circle by 4e-7, the polygon by 1e-6.
        EXPECT_NEAR(direction.dot(grain.support(direction)), 1, 3e-6);
    }
}

TEST(SmoothOutline, getsBetterWithMoreSegments)
{
    const std::vector<Vector2> polygon = ellipsePolygon(2, 1, 0.3, Vector2::Zero(), 2000);
    double before = 1;
    for (const int segments : {3, 4, 6, 10, 20})
    {
        const PolyBezier grain(fitSmoothOutline(polygon, segments));
        double largest = 0;
        for (int i = 0; i < 1000; ++i)
        {
            const double angle = 2 * M_PI * i / 1000;
            const Vector2 local = Rotation<2>(0.3).applyInverse(Vector2(std::cos(angle), std::sin(angle)));
            const double exact = std::hypot(2 * local.x(), local.y());
            const Vector2 direction(std::cos(angle), std::sin(angle));
            largest = std::max(largest, std::abs(direction.dot(grain.support(direction)) - exact));
        }
        EXPECT_LT(largest, before) << segments << " segments";
        before = largest;
    }
    EXPECT_LT(before, 1e-4);
}

TEST(SmoothOutline, isConvexAndSmoothForSharpCornersAndStraightSides)
{
    test::RandomSource random(31);
    for (int trial = 0; trial < 150; ++trial)
    {
        const int sides = random.integer(3, 12);
        const double size = random.logUniform(1e-4, 1e4);
        std::vector<Vector2> polygon = test::randomPolygon(sides, size, random).vertices();
        const Vector2 shift = size * random.direction();
        for (Vector2& vertex : polygon)
        {
            vertex += shift;
        }
        const int segments = random.integer(fewestSegments, 20);
        const PolyBezier grain(fitSmoothOutline(polygon, segments));
        EXPECT_EQ(grain.segments().size(), static_cast<std::size_t>(segments));
        EXPECT_LE(grain.largestJointAngle(), tolerances::joint)
            << sides << " sides, " << segments << " segments";
    }
}

TEST(SmoothOutline, followsASquareASliverAndAHalfDisk)
{
    EXPECT_NEAR(relativeAreaError({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 10), 0, 0.01);
    EXPECT_NEAR(relativeAreaError({{0, 0}, {40, 0}, {40, 1}, {0, 1}}, 10), 0, 0.02);
    std::vector<Vector2> halfDisk;
    for (int i = 0; i <= 100; ++i)
    {
        halfDisk.emplace_back(std::cos(M_PI * i / 100), std::sin(M_PI * i / 100));
    }
    EXPECT_NEAR(relativeAreaError(halfDisk, 10), 0, 0.005);
}

/// Without the support values' part in OutlineProblem slender outlines shrink.
TEST(SmoothOutline, followsSlenderPolygons)
{
    test::RandomSource random(32);
    std::vector<double> errors;
    for (int trial = 0; trial < 200; ++trial)
    {
        std::vector<Vector2> polygon = test::randomPolygon(random.integer(3, 12), 1, random).vertices();
        const Rotation<2> turn(random.uniform(0, 2 * M_PI));
        for (Vector2& vertex : polygon)
        {
            vertex = turn.apply(Vector2(10 * vertex.x(), vertex.y()));
        }
        errors.push_back(std::abs(relativeAreaError(polygon, 10)));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[100], 0.007);
    EXPECT_LT(errors.back(), 0.2);
}

TEST(SmoothOutline, refusesWhatCannotBeFitted)
{
    const std::vector<Vector2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    EXPECT_THROW(fitSmoothOutline(square, 2), ValueError);
    EXPECT_THROW(fitSmoothOutline(square, mostSegments + 1), ValueError);
    EXPECT_NO_THROW(fitSmoothOutline(square, mostSegments));
    EXPECT_THROW(fitSmoothOutline({{0, 0}, {1, 0}}, 10), ValueError);
    EXPECT_THROW(fitSmoothOutline({{0, 0}, {1, 0}, {2, 0}}, 10), ValueError);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(fitSmoothOutline({{0, 0}, {1, nan}, {0, 1}}, 10), ValueError);
}
