#include "core/geometry/secondMoments.hpp"

#include "core/shapes/shape.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;

TEST(SecondMoments, ofARectangle)
{
    const double a = 3;
    const double b = 0.5;
    const ConvexPolygon brick({{0, 0}, {a, 0}, {a, b}, {0, b}});
    const Eigen::Matrix2d found = secondMoments(brick.outline());
    EXPECT_NEAR(found(0, 0), a * a * a * b / 12, 1e-14);
    EXPECT_NEAR(found(1, 1), a * b * b * b / 12, 1e-14);
    EXPECT_NEAR(found(0, 1), 0, 1e-15);
    EXPECT_NEAR(found(1, 0), 0, 1e-15);
}

TEST(SecondMoments, ofAnEllipseAnywhere)
{
    const double a = 2;
    const double b = 0.3;
    const double area = M_PI * a * b;
    const Outline tilted = placed(Ellipse(a, b).outline(), {Vector2(0.4, -1.1), Rotation<2>(0.7)});
    const Vector2 along(std::cos(0.7), std::sin(0.7));
    const Vector2 across = perpendicular(along);
    const Vector2 centre(0.4, -1.1);
    const Eigen::Matrix2d expected = area * centre * centre.transpose() + area * a * a / 4 * along * along.transpose()
        + area * b * b / 4 * across * across.transpose();
    EXPECT_LT((secondMoments(tilted) - expected).norm(), 1e-14 * expected.norm());
}

TEST(SecondMoments, theirTraceIsThePolarMoment)
{
    test::RandomSource random(41);
    for (int i = 0; i < 50; ++i)
    {
        const PolyBezier pebble = test::randomPolyBezier({}, random);
        const double polar = pebble.massProperties().polarMoment;
        EXPECT_NEAR(secondMoments(pebble.outline()).trace() / polar, 1, 1e-13) << i;
    }
}
