#include "core/base/periodicCell.hpp"

#include "core/base/setupError.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;

namespace
{

/// Straight, tilted, far tilted, left-handed, one direction each.
std::vector<PeriodicCell> cells()
{
    return {
        {Vector2(1, 2), Vector2(3, 0), Vector2(0, 2)},      {Vector2(1, 2), Vector2(3, 0), Vector2(1.2, 2)},
        {Vector2(-1, 2), Vector2(3, 0.5), Vector2(-17, 2)}, {Vector2(0, 0), Vector2(0.5, 2), Vector2(3, 1)},
        {Vector2(1, 2), Vector2(3, 1), Vector2(0, 0)},      {Vector2(1, 2), Vector2(0, 0), Vector2(-1, 2)}};
}

/// The shortest of all images within reach of any of these cells.
double shortestImage(const PeriodicCell& cell, const Vector2& separation)
{
    double least = separation.norm();
    for (int first = -60; first <= 60; ++first)
    {
        for (int second = -60; second <= 60; ++second)
        {
            least = std::min(least, (separation + cell.offset({first, second})).norm());
        }
    }
    return least;
}

} // namespace

TEST(PeriodicCell, nearestShiftIsTheShortestImage)
{
    test::RandomSource random(201);
    for (const PeriodicCell& cell : cells())
    {
        for (int i = 0; i < 100; ++i)
        {
            const Vector2 separation(random.uniform(-10, 10), random.uniform(-10, 10));
            const Shift shift = cell.nearestShift(separation);
            ASSERT_NEAR((separation + cell.offset(shift)).norm(), shortestImage(cell, separation), 1e-12);
        }
    }
}

TEST(PeriodicCell, wrapsIntoTheCell)
{
    test::RandomSource random(202);
    for (const PeriodicCell& cell : cells())
    {
        for (int i = 0; i < 100; ++i)
        {
            const Vector2 before(random.uniform(-50, 50), random.uniform(-50, 50));
            Vector2 position = before;
            const Shift shift = cell.wrap(position);
            ASSERT_EQ(position, Vector2(before + cell.offset(shift)));
            const Vector2 fraction = cell.fractionOf(position);
            ASSERT_GE(fraction.minCoeff(), -1e-12);
            ASSERT_LE(fraction.maxCoeff(), 1 + 1e-12);
        }
    }
}

TEST(PeriodicCell, aDirectionThatDoesNotRepeatStaysAsItIs)
{
    const PeriodicCell cell(Vector2(1, 0), Vector2(2, 0), Vector2(0, 0));
    Vector2 position(6.5, 1e9);
    EXPECT_EQ(cell.wrap(position), (Shift{-2, 0}));
    EXPECT_EQ(position, Vector2(2.5, 1e9));
    EXPECT_EQ(cell.widths().x(), 2);
    EXPECT_EQ(cell.widths().y(), std::numeric_limits<double>::infinity());
}

TEST(PeriodicCell, widthsArePerpendicularToTheSides)
{
    const PeriodicCell cell(Vector2(0, 0), Vector2(5, 0), Vector2(3, 3));
    EXPECT_NEAR(cell.widths().x(), 5 * std::sqrt(0.5), 1e-14);
    EXPECT_NEAR(cell.widths().y(), 3, 1e-14);
}

TEST(PeriodicCell, whatCannotBeWrappedStaysWhereItIs)
{
    const PeriodicCell cell(Vector2(0, 0), Vector2(1, 0), Vector2(0, 1));
    for (const double far : {1e12, -1e300, std::numeric_limits<double>::infinity()})
    {
        Vector2 position(0.5, far);
        EXPECT_EQ(cell.wrap(position), Shift{});
        EXPECT_EQ(position, Vector2(0.5, far));
        EXPECT_EQ(cell.nearestShift(position), Shift{});
    }
    Vector2 position(std::numeric_limits<double>::quiet_NaN(), 3);
    EXPECT_EQ(cell.wrap(position), Shift{});
    EXPECT_EQ(cell.nearestShift(position), Shift{});
}

TEST(PeriodicCell, refusesWhatIsNoCell)
{
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(PeriodicCell(Vector2(0, 0), Vector2(0, 0), Vector2(0, 0)), ValueError);
    EXPECT_THROW(PeriodicCell(Vector2(0, 0), Vector2(1, 2), Vector2(-2, -4)), ValueError);
    EXPECT_THROW(PeriodicCell(Vector2(0, infinity), Vector2(1, 0), Vector2(0, 1)), ValueError);
    EXPECT_THROW(PeriodicCell(Vector2(0, 0), Vector2(1, 0), Vector2(0, infinity)), ValueError);
}
