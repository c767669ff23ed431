#include "coupling/geometry/regionMoments.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;
using namespace chesil::test;

TEST(RegionMoments, halfDisk)
{
    EllipticArc arc;
    const RegionMoments half = sliverMoments(arc, 0, M_PI, Vector2(1, 0)).aboutPoint(Vector2(-1, 0));
    EXPECT_NEAR(half.area, M_PI / 2, 1e-15);
    EXPECT_NEAR(half.first.x(), 0, 1e-15);
    EXPECT_NEAR(half.first.y(), 2.0 / 3, 1e-15);
}

/// Short parts keep their digits relative to themselves, not to the whole curve. A sliver of the opening w
/// has the area w^3/12 (1 - w^2/20 + ...) on a unit circle.
TEST(RegionMoments, shortArcsKeepTheirDigits)
{
    EllipticArc arc;
    for (const double w : {1.0, 0.500001, 0.499999, 0.1, 1e-3, 1e-6})
    {
        long double sum = 0;
        long double term = static_cast<long double>(w);
        for (int k = 3; k < 30; k += 2)
        {
            term *= -static_cast<long double>(w) * w / ((k - 1) * k);
            sum -= term;
        }
        const RegionMoments found = sliverMoments(arc, 0, w, arc.at(0));
        EXPECT_NEAR(found.area / static_cast<double>(sum / 2), 1, 4e-15) << w;
    }
}

/// x = t, y = t^2 as a cubic: a part of the length L and its chord enclose L^3/6. The centroid lies below the
/// chord's middle by two fifths of the sagitta L^2/4.
TEST(RegionMoments, shortPartsOfAParabolaKeepTheirDigits)
{
    const CubicBezier parabola(
        {Vector2(0, 0), Vector2(1.0 / 3, 0), Vector2(2.0 / 3, 1.0 / 3), Vector2(1, 1)});
    for (const double length : {1.0, 0.125, 0x1p-10, 0x1p-20})
    {
        const double from = length == 1 ? 0 : 0.5;
        const RegionMoments found = sliverMoments(parabola, from, from + length);
        EXPECT_NEAR(found.area / (length * length * length / 6), 1, 1e-14 / length) << length;
        const Vector2 centroid = found.first / found.area;
        EXPECT_NEAR(centroid.x() / length, 0.5, 1e-14 / length) << length;
        EXPECT_NEAR(centroid.y(), (2 * from + length) * length / 2 - length * length / 10, 1e-14) << length;
    }
}

/// Parts add up to the whole, for the closed forms of a general cubic.
TEST(RegionMoments, partsOfACubicAddUp)
{
    RandomSource random(41);
    for (int i = 0; i < 1000; ++i)
    {
        RandomGrainOptions options;
        options.segments = 5;
        const CubicBezier curve = randomSegments(options, random).front();
        const double middle = random.uniform(0, 1);
        const RegionMoments whole = sliverMoments(curve, 0, 1);
        RegionMoments sum = sliverMoments(curve, 0, middle);
        sum += triangleMoments(curve.at(middle) - curve.start(), curve.end() - curve.start());
        sum += sliverMoments(curve, middle, 1).aboutPoint(curve.start() - curve.at(middle));
        ASSERT_NEAR(sum.area, whole.area, 1e-14);
        ASSERT_NEAR(sum.first.x(), whole.first.x(), 1e-14);
        ASSERT_NEAR(sum.first.y(), whole.first.y(), 1e-14);
    }
}
