#include "core/shapes/shape.hpp"

#include "unit/knownShapes.hpp"
#include "unit/preciseCurve.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

/// Distance from the origin of the furthest of many points of the outline.
double furthestPoint(const Outline& outline)
{
    test::Real furthest = 0;
    for (const OutlinePiece& piece : outline)
    {
        constexpr int samples = 2000;
        for (int i = 0; i <= samples; ++i)
        {
            const test::PrecisePoint p =
                std::visit([&](const auto& q) { return test::preciseAt(q, test::Real(i) / samples); }, piece);
            furthest = std::max(furthest, std::hypot(p.x, p.y));
        }
    }
    return static_cast<double>(furthest);
}

void expectTightBound(const Shape& shape)
{
    const double furthest = furthestPoint(outline(shape));
    EXPECT_GE(boundingRadius(shape), furthest * (1 - 4 * std::numeric_limits<double>::epsilon()));
    EXPECT_LE(boundingRadius(shape), furthest * 1.01);
}

} // namespace

TEST(Bounds, boundingRadiusIsABoundAndTight)
{
    test::RandomSource random(61);
    for (int i = 0; i < 100; ++i)
    {
        test::RandomGrainOptions options;
        options.segments = random.integer(4, 16);
        options.straight = i % 2;
        options.radius = random.logUniform(1e-3, 1e3);
        options.waviness = random.uniform(0, 0.95);
        expectTightBound(test::randomPolyBezier(options, random));
        expectTightBound(test::randomPolygon(random.integer(3, 12), options.radius, random));
        expectTightBound(Ellipse(random.logUniform(0.01, 100), 1));
        expectTightBound(Circle(options.radius));
    }
    expectTightBound(PolyBezier(test::ellipseSegments(3, 1, 1)));
    expectTightBound(PolyBezier(test::ellipseSegments(4, 10, 1)));
    expectTightBound(test::roundedSquare(2, 0.01));
}
