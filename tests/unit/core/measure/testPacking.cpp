#include "core/measure/packing.hpp"

#include "core/base/setupError.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace chesil;

TEST(Packing, hexagonalDisks)
{
    const Packing found = packing(std::vector<double>(6, M_PI / 4), 6 * std::sqrt(0.75));
    EXPECT_DOUBLE_EQ(found.solidFraction, M_PI / std::sqrt(12));
    EXPECT_DOUBLE_EQ(found.voidRatio.value(), std::sqrt(12) / M_PI - 1);
}

TEST(Packing, overlapsAreNotSubtracted)
{
    const Packing found = packing({3, 2}, 4);
    EXPECT_EQ(found.solidFraction, 1.25);
    EXPECT_EQ(found.voidRatio, -0.2);
}

TEST(Packing, withoutGrains)
{
    EXPECT_EQ(packing({}, 4).solidFraction, 0);
    EXPECT_FALSE(packing({}, 4).voidRatio);
}

TEST(Packing, refusesAreasThatAreNone)
{
    const double infinite = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -1.0, infinite, nan})
    {
        EXPECT_THROW(packing({1}, bad), ValueError);
    }
    for (const double bad : {-1.0, infinite, nan})
    {
        EXPECT_THROW(packing({1, bad}, 1), ValueError);
    }
}
