#include "core/shapes/longAxis.hpp"

#include "core/geometry/secondMoments.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

std::vector<Vector2> turned(std::vector<Vector2> points, double angle)
{
    for (Vector2& point : points)
    {
        point = Rotation<2>(angle).apply(point);
    }
    return points;
}

std::vector<Vector2> regularPolygon(int corners)
{
    std::vector<Vector2> points;
    for (int i = 0; i < corners; ++i)
    {
        points.emplace_back(Rotation<2>(2 * M_PI * i / corners).apply(Vector2(0.01, 0)));
    }
    return points;
}

} // namespace

TEST(LongAxis, liesAlongTheLongerHalfAxis)
{
    EXPECT_NEAR(longAxis(Ellipse(0.02, 0.01)).value(), 0, 1e-12);
    EXPECT_NEAR(std::abs(longAxis(Ellipse(0.01, 0.02)).value()), M_PI / 2, 1e-12);
    EXPECT_NEAR(std::abs(longAxis(Ellipse(0.01, 0.0100001)).value()), M_PI / 2, 1e-6) << "hardly longer";
}

TEST(LongAxis, turnsWithTheShape)
{
    // A brick's is along its sides, not along its diagonal (the largest Feret diameter).
    const std::vector<Vector2> brick{{0, 0}, {0.03, 0}, {0.03, 0.02}, {0, 0.02}};
    for (const double angle : {-1.4, -0.3, 0.0, 0.9, 1.5})
    {
        EXPECT_NEAR(longAxis(ConvexPolygon(turned(brick, angle))).value(), angle, 1e-12);
    }
}

TEST(LongAxis, roundAndRegularShapesHaveNone)
{
    EXPECT_FALSE(longAxis(Circle(1)));
    EXPECT_FALSE(longAxis(Circle(1e-50)));
    EXPECT_FALSE(longAxis(Ellipse(0.3, 0.3)));
    for (const int corners : {3, 4, 5, 6, 17})
    {
        EXPECT_FALSE(longAxis(ConvexPolygon(regularPolygon(corners)))) << corners;
    }
}

TEST(LongAxis, hasTheLargestSecondMoment)
{
    test::RandomSource random(42);
    for (int i = 0; i < 50; ++i)
    {
        const PolyBezier pebble = test::randomPolyBezier({}, random);
        const double axis = longAxis(pebble).value();
        const Eigen::Matrix2d moments = secondMoments(pebble.outline());
        const auto along = [&](double angle)
        {
            const Vector2 direction(std::cos(angle), std::sin(angle));
            return direction.dot(moments * direction);
        };
        for (int k = 1; k < 36; ++k)
        {
            EXPECT_GT(along(axis), along(axis + k * M_PI / 36));
        }
    }
}
