#include "generate/fit/pixelRegion.hpp"

#include "unit/generate/drawnShapes.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

std::vector<Vector2> rectangle(double left, double low, double right, double high)
{
    return {{left, low}, {right, low}, {right, high}, {left, high}};
}

} // namespace

TEST(PixelRegion, countsThePixelsWithTheirCentreInside)
{
    EXPECT_EQ(PixelRegion(rectangle(0, 0, 4, 3)).count(), 12);
    EXPECT_EQ(PixelRegion(rectangle(0.4, 0.4, 3.6, 2.6)).count(), 12);
    EXPECT_EQ(PixelRegion(rectangle(0.6, 0.6, 3.4, 2.4)).count(), 2);
    EXPECT_EQ(PixelRegion(rectangle(-4, -3, 0, 0)).count(), 12);
    EXPECT_EQ(PixelRegion(rectangle(0.6, 0.6, 0.9, 0.9)).count(), 0);
}

TEST(PixelRegion, agreesWithADrawnTriangle)
{
    const std::vector<Vector2> triangle{{1.3, 2.1}, {27.7, 5.9}, {9.2, 31.4}};
    const Silhouette silhouette =
        test::drawn(40, 40,
                    [&](const Vector2& p)
                    {
                        bool inside = true;
                        for (std::size_t i = 0; i < 3; ++i)
                        {
                            inside =
                                inside && cross(triangle[(i + 1) % 3] - triangle[i], p - triangle[i]) > 0;
                        }
                        return inside;
                    });
    EXPECT_EQ(PixelRegion(triangle).count(), silhouette.count());
    EXPECT_EQ(PixelRegion::differing(PixelRegion(triangle), PixelRegion(silhouette)), 0);
}

TEST(PixelRegion, keepsHollowsAndHoles)
{
    // A ring of 5 x 5 pixels with a hole of 3 x 3.
    const Silhouette ring = test::drawn(
        5, 5, [](const Vector2& p) { return (p - Vector2(2.5, 2.5)).cwiseAbs().maxCoeff() > 1.5; });
    EXPECT_EQ(ring.count(), 16);
    EXPECT_EQ(PixelRegion(ring).count(), 16);
    const PixelRegion full(rectangle(0, 0, 5, 5));
    EXPECT_EQ(PixelRegion::differing(PixelRegion(ring), full), 9);
    EXPECT_DOUBLE_EQ(fitAccuracy(full, PixelRegion(ring)), 1 - 9.0 / 16);
}

TEST(PixelRegion, differenceOfShiftedAndSeparateShapes)
{
    const PixelRegion a(rectangle(0, 0, 4, 4));
    EXPECT_EQ(PixelRegion::differing(a, a), 0);
    EXPECT_EQ(PixelRegion::differing(a, PixelRegion(rectangle(1, 0, 5, 4))), 8);
    EXPECT_EQ(PixelRegion::differing(a, PixelRegion(rectangle(10, 10, 12, 12))), 20);
    EXPECT_EQ(PixelRegion::differing(PixelRegion(rectangle(-9, -9, -7, -7)), a), 20);
}
