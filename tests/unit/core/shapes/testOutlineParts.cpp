#include "core/shapes/ellipse.hpp"
#include "core/shapes/polyBezier.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace chesil
{

namespace
{

/// The part at a normal begins no later than that, the next one no earlier, and bends nowhere more than it says.
template <class ShapeType>
void expectPartsHold(const ShapeType& shape, test::RandomSource& random, int normals)
{
    // A normal on the border of two parts may be counted to either.
    constexpr double border = 1e-12;
    for (int i = 0; i < normals; ++i)
    {
        const Vector2 normal = random.direction();
        const std::size_t part = shape.partAt(normal);
        const Vector2 first = shape.partStart(part);
        const Vector2 last = shape.partStart(shape.partAfter(part));
        EXPECT_EQ(shape.partBefore(shape.partAfter(part)), part);
        EXPECT_NEAR(first.norm(), 1, border);
        EXPECT_GE(cross(first, normal), -border) << normal.transpose();
        EXPECT_GE(cross(normal, last), -border) << normal.transpose();
        EXPECT_LE(shape.partRadius(part), shape.curvedSupport(normal).radius.value * (1 + 1e-9)) << normal.transpose();
        EXPECT_GE(shape.partRadius(part), shape.leastRadius());
    }
}

} // namespace

TEST(OutlineParts, ofEllipsesHoldTheirNormalsAndRadii)
{
    test::RandomSource random(20261123);
    for (int i = 0; i < 200; ++i)
    {
        expectPartsHold(Ellipse(random.logUniform(1e-3, 1), random.logUniform(1e-3, 1)), random, 200);
    }
    expectPartsHold(Ellipse(1, 1), random, 200);
}

TEST(OutlineParts, ofPolyBeziersHoldTheirNormalsAndRadii)
{
    test::RandomSource random(20261124);
    for (int i = 0; i < 200; ++i)
    {
        test::RandomGrainOptions options;
        options.segments = random.integer(3, 20);
        options.straight = options.segments < 8 ? 0 : i % 3;
        expectPartsHold(test::randomPolyBezier(options, random), random, 200);
    }
}

} // namespace chesil
