#include "core/base/setupError.hpp"
#include "core/shapes/scaledShape.hpp"
#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;

TEST(ScaledShape, allLengthsGrowAlike)
{
    test::RandomSource random(401);
    for (const NamedShape& named : test::shapesOfEachKind(402))
    {
        for (int i = 0; i < 50; ++i)
        {
            const double scale = random.logUniform(1e-4, 1e4);
            const Shape copy = scaled(named.shape, scale);
            EXPECT_EQ(copy.index(), named.shape.index());
            const double radius = boundingRadius(named.shape);
            EXPECT_NEAR(boundingRadius(copy) / (scale * radius), 1, 1e-13);
            const MassProperties mass = massProperties(named.shape);
            EXPECT_NEAR(massProperties(copy).area / (scale * scale * mass.area), 1, 1e-12);
            EXPECT_NEAR(massProperties(copy).polarMoment / (std::pow(scale, 4) * mass.polarMoment), 1, 1e-12);
            for (int k = 0; k < 20; ++k)
            {
                const Vector2 direction = random.direction();
                const Vector2 expected = scale * support(named.shape, direction);
                EXPECT_NEAR((support(copy, direction) - expected).dot(direction), 0, 1e-12 * scale * radius)
                    << named.name;
            }
        }
    }
}

TEST(ScaledShape, byAPowerOfTwoAndBackIsTheSameOutline)
{
    for (const NamedShape& named : test::shapesOfEachKind(403))
    {
        const Shape back = scaled(scaled(named.shape, 0x1p-7), 0x1p7);
        EXPECT_DOUBLE_EQ(massProperties(back).area, massProperties(named.shape).area) << named.name;
        EXPECT_EQ(support(back, Vector2(0.3, 0.4)), support(named.shape, Vector2(0.3, 0.4))) << named.name;
    }
}

TEST(ScaledShape, impossibleScalesAreRefused)
{
    for (const NamedShape& named : test::shapesOfEachKind(404))
    {
        for (const double bad : {0.0, -1.0, 1e70, std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()})
        {
            EXPECT_THROW(scaled(named.shape, bad), ValueError) << named.name << ' ' << bad;
        }
    }
}
