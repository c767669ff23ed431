#include "core/shapes/shape.hpp"

#include "unit/knownShapes.hpp"
#include "unit/preciseCurve.hpp"
#include "unit/randomGrain.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;

namespace
{

/// The bar of the issue: how far a support point may fall short of, or exceed, the outline's reach; over the
/// size.
constexpr double bar = 1e-14;

double sizeOf(const Shape& shape) { return 2 * std::sqrt(massProperties(shape).area / M_PI); }

/// |reach of the support point - reach of the outline| over the size.
double supportError(const Shape& shape, const test::HeightSweep& sweep, const Vector2& direction)
{
    const Vector2 point = support(shape, direction);
    const test::Real length = std::hypot(test::Real(direction.x()), test::Real(direction.y()));
    const test::Real reach =
        (point.x() * test::Real(direction.x()) + point.y() * test::Real(direction.y())) / length;
    return static_cast<double>(std::abs(reach - sweep.height(direction)) / sizeOf(shape));
}

/// Three quarters anywhere, of any length; the rest at or within 1e-16..1e-6 rad of a joint's normal.
Vector2 searchDirection(const Outline& outline, test::RandomSource& random)
{
    const Vector2 any = random.logUniform(1e-6, 1e6) * random.direction();
    const auto* segment = std::get_if<CubicBezier>(
        &outline[static_cast<std::size_t>(random.integer(0, static_cast<int>(outline.size()) - 1))]);
    const int choice = random.integer(0, 7);
    if (!segment || choice > 1)
    {
        return any;
    }
    const Vector2 tangent = random.integer(0, 1) == 0 ? segment->startTangent() : segment->endTangent();
    const Vector2 normal = -perpendicular(tangent);
    const double turn =
        random.uniform(-1, 1) > 0 ? random.logUniform(1e-16, 1e-6) : -random.logUniform(1e-16, 1e-6);
    return choice == 0 ? normal : Vector2(normal + turn * tangent);
}

double largestError(const Shape& shape, int directions, test::RandomSource& random)
{
    const Outline boundary = outline(shape);
    const test::HeightSweep sweep(boundary, 48);
    double largest = 0;
    for (int i = 0; i < directions; ++i)
    {
        largest = std::max(largest, supportError(shape, sweep, searchDirection(boundary, random)));
    }
    return largest;
}

} // namespace

TEST(SupportSweep, referenceIsGoodToLongDouble)
{
    test::RandomSource random(40);
    const test::HeightSweep sweep(Ellipse(3, 0.2).outline(), 48);
    for (int i = 0; i < 1000; ++i)
    {
        const Vector2 direction = random.direction();
        const test::Real length = std::hypot(test::Real(direction.x()), test::Real(direction.y()));
        const test::Real expected =
            std::hypot(3 * test::Real(direction.x()), test::Real(0.2) * direction.y()) / length;
        EXPECT_LT(std::abs(sweep.height(direction) - expected), 1e-17L);
    }
}

TEST(SupportSweep, polyBezierGrains)
{
    constexpr int grains = 100;
    constexpr int directionsOfAGrain = 1000;
    test::RandomSource random(41);
    double largest = 0;
    for (int i = 0; i < grains; ++i)
    {
        test::RandomGrainOptions options;
        options.segments = random.integer(7, 16);
        options.straight = i % 3;
        options.nearlyStraight = i % 2 + (i % 5 == 0 ? 1 : 0);
        options.radius = random.logUniform(1e-4, 1e2);
        options.waviness = random.uniform(0, 0.95);
        if (2 * (options.straight + options.nearlyStraight) > options.segments)
        {
            options.segments = 2 * (options.straight + options.nearlyStraight) + 1;
        }
        const double error =
            largestError(test::randomPolyBezier(options, random), directionsOfAGrain, random);
        EXPECT_LE(error, bar) << "grain " << i;
        largest = std::max(largest, error);
    }
    test::record("firstLight", "supportRelativeError", largest, "-");
    std::printf("seed 41: largest error %.2g of the size in %d directions\n", largest,
                grains * directionsOfAGrain);
}

TEST(SupportSweep, polyBeziersWithFlatSidesAndCorners)
{
    test::RandomSource random(42);
    const auto corners = test::rectangleVertices(3, 1, Vector2(0.3, 0.1));
    EXPECT_LE(largestError(PolyBezier(test::polygonSegments(corners)), 4000, random), bar);
    EXPECT_LE(largestError(test::roundedSquare(2, 0.3), 4000, random), bar);
    EXPECT_LE(largestError(test::roundedSquare(2, 1e-6), 4000, random), bar);
    EXPECT_LE(largestError(PolyBezier(test::ellipseSegments(4, 5, 0.1)), 4000, random), bar);
    // A lens of two arcs, and a half disk-like grain whose arc turns by 170 degrees with sharp corners at its
    // ends.
    const std::vector<CubicBezier> lens{
        CubicBezier({Vector2(0, 0), Vector2(1, -0.5), Vector2(2, -0.5), Vector2(3, 0)}),
        CubicBezier({Vector2(3, 0), Vector2(2, 0.7), Vector2(1, 0.7), Vector2(0, 0)})};
    EXPECT_LE(largestError(PolyBezier(lens), 4000, random), bar);
    const double turn = 170 * M_PI / 180;
    const Vector2 end = Vector2(1.1, 0) + 0.5 * Vector2(std::cos(turn), std::sin(turn));
    const std::vector<CubicBezier> hook{CubicBezier({Vector2(0, 0), Vector2(1, 0), Vector2(1.1, 0), end}),
                                        CubicBezier::straight(end, {0, 0})};
    EXPECT_LE(largestError(PolyBezier(hook), 4000, random), bar);
}

TEST(SupportSweep, polygonsCirclesAndEllipses)
{
    test::RandomSource random(43);
    for (int i = 0; i < 20; ++i)
    {
        EXPECT_LE(
            largestError(test::randomPolygon(random.integer(3, 20), random.logUniform(1e-3, 1e3), random),
                         500, random),
            bar);
        const double a = random.logUniform(1e-3, 1e3);
        EXPECT_LE(largestError(Ellipse(a, a * random.logUniform(1e-2, 1e2)), 500, random), bar);
        EXPECT_LE(largestError(Circle(a), 500, random), bar);
    }
}
