#include "core/shapes/shape.hpp"

#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;

namespace
{

Vector2 normalAt(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Richardson's central difference of f at x, of order step^4.
template <class Function>
double differenceOf(const Function& f, double x, double step)
{
    const double wide = (f(x + 2 * step) - f(x - 2 * step)) / (4 * step);
    const double narrow = (f(x + step) - f(x - step)) / (2 * step);
    return narrow + (narrow - wide) / 3;
}

/// The radius is dp/da along the tangent, and its derivatives are those of the radius, wherever the normal
/// may turn by the step without leaving the curve.
template <class ShapeType>
int checkDerivatives(const ShapeType& shape, test::RandomSource& random)
{
    constexpr double step = 1e-4;
    const double angle = random.uniform(-M_PI, M_PI);
    const auto radiusAt = [&](double a) { return shape.curvedSupport(normalAt(a)).radius; };
    const CurvedPoint<2> here = shape.curvedSupport(normalAt(angle));
    if (!(here.room > 4 * step))
    {
        return 0;
    }
    // What the differences lose: rounding over the step, and the next derivatives, which a tight bend has.
    const CurvatureRadius& radius = here.radius;
    const double scale = shape.boundingRadius() + std::abs(radius.first) + std::abs(radius.second);
    const double arc = differenceOf(
        [&](double a) { return perpendicular(normalAt(angle)).dot(shape.curvedSupport(normalAt(a)).point); }, angle, step);
    const double first = differenceOf([&](double a) { return radiusAt(a).value; }, angle, step);
    const double second = differenceOf([&](double a) { return radiusAt(a).first; }, angle, step);
    EXPECT_NEAR(arc, radius.value, 1e-7 * scale) << angle;
    EXPECT_NEAR(first, radius.first, 1e-7 * scale) << angle;
    EXPECT_NEAR(second, radius.second, 1e-6 * scale) << angle;
    return 1;
}

} // namespace

TEST(CurvatureRadius, derivativesOfEllipses)
{
    test::RandomSource random(31);
    int checked = 0;
    for (int i = 0; i < 500; ++i)
    {
        checked += checkDerivatives(Ellipse(random.uniform(0.3, 1), random.uniform(0.3, 1)), random);
    }
    EXPECT_EQ(checked, 500);
}

TEST(CurvatureRadius, derivativesOfPolyBeziers)
{
    test::RandomSource random(32);
    int checked = 0;
    for (int i = 0; i < 500; ++i)
    {
        checked += checkDerivatives(test::randomPolyBezier(test::RandomGrainOptions(), random), random);
    }
    EXPECT_GT(checked, 450);
}

TEST(CurvatureRadius, aDiskHasNoDerivativesAndACornerNoRadius)
{
    test::RandomSource random(33);
    EXPECT_EQ(checkDerivatives(Circle(0.7), random), 1);
    const CurvatureRadius disk = Circle(0.7).curvedSupport(normalAt(1)).radius;
    EXPECT_EQ(disk.first, 0);
    EXPECT_EQ(disk.second, 0);
    const CurvatureRadius corner = ConvexPolygon({{0, 0}, {1, 0}, {0, 1}}).curvedSupport(normalAt(0.1)).radius;
    EXPECT_EQ(corner.value, 0);
    EXPECT_EQ(corner.first, 0);
    EXPECT_EQ(corner.second, 0);
}
