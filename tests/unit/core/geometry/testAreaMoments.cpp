#include "core/geometry/areaMoments.hpp"

#include "unit/knownShapes.hpp"
#include "unit/preciseCurve.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

/// Sums of some tens of terms, each as large as the result.
constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();

} // namespace

TEST(AreaMoments, ofARectangleAnywhere)
{
    const double width = 2;
    const double height = 3;
    for (const Vector2& centre : {Vector2(0, 0), Vector2(1.5, -0.5)})
    {
        const AreaMoments moments =
            regionMoments(test::polygonSegments(test::rectangleVertices(width, height, centre)));
        const double polar = width * height * (width * width + height * height) / 12;
        EXPECT_NEAR(moments.area, width * height, rounding * 6);
        EXPECT_LT((moments.centroid() - centre).norm(), rounding);
        EXPECT_NEAR(moments.polar, polar + 6 * centre.squaredNorm(), 10 * rounding);
        EXPECT_NEAR(moments.polarAboutCentroid(), polar, 10 * rounding);
    }
}

TEST(AreaMoments, underAParabolaAsTheIntegralsSay)
{
    // Between y = x^2 and y = 1, |x| <= 1: area 4/3, centroid (0, 3/5), polar 4/15 + 4/7.
    const CubicBezier arc(
        {Vector2(-1, 1), Vector2(-1.0 / 3, -1.0 / 3), Vector2(1.0 / 3, -1.0 / 3), Vector2(1, 1)});
    const AreaMoments moments = regionMoments({arc, CubicBezier::straight({1, 1}, {-1, 1})});
    EXPECT_NEAR(moments.area, 4.0 / 3, rounding);
    EXPECT_LT((moments.centroid() - Vector2(0, 0.6)).norm(), rounding);
    EXPECT_NEAR(moments.polar, 4.0 / 15 + 4.0 / 7, rounding);
}

TEST(AreaMoments, clockwiseIsNegative)
{
    std::vector<Vector2> vertices = test::rectangleVertices(1, 1);
    std::swap(vertices[1], vertices[3]);
    EXPECT_NEAR(regionMoments(test::polygonSegments(vertices)).area, -1, rounding);
}

TEST(AreaMoments, ofRandomSegmentsAsInLongDouble)
{
    test::RandomSource random(21);
    for (int trial = 0; trial < 100; ++trial)
    {
        // A chain that may cross itself: the integrals do not care.
        std::vector<CubicBezier> chain;
        for (int i = 0; i < 4; ++i)
        {
            std::array<Vector2, 4> points;
            for (Vector2& point : points)
            {
                const double x = random.uniform(-1, 1);
                point = Vector2(x, random.uniform(-1, 1));
            }
            chain.emplace_back(points);
        }
        chain = test::joined(chain);
        const AreaMoments moments = regionMoments(chain);
        const test::PreciseMoments expected = test::preciseMoments(chain);
        EXPECT_NEAR(moments.area, static_cast<double>(expected.area), rounding);
        EXPECT_NEAR(moments.first.x(), static_cast<double>(expected.first.x), rounding);
        EXPECT_NEAR(moments.first.y(), static_cast<double>(expected.first.y), rounding);
        EXPECT_NEAR(moments.polar, static_cast<double>(expected.polar), rounding);
    }
}

TEST(AreaMoments, referenceIsRightForACircleOfManySegments)
{
    // The reference itself: 200 segments err by (2/27) (pi/400)^6 = 2e-14 of the radius at most, four times
    // that in the polar moment.
    const test::PreciseMoments moments = test::preciseMoments(test::ellipseSegments(200, 1, 1));
    EXPECT_NEAR(static_cast<double>(moments.area), M_PI, 1e-13);
    EXPECT_NEAR(static_cast<double>(moments.polar), M_PI / 2, 1e-13);
}
