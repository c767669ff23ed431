#include "generate/image/convexHull.hpp"

#include "core/geometry/convexity.hpp"
#include "generate/fit/pixelRegion.hpp"
#include "unit/generate/drawnShapes.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

/// Centre plus or minus `reach` in x and in y, of each dark pixel.
std::vector<Vector2> pointsAround(const Silhouette& silhouette, const std::vector<Vector2>& steps)
{
    std::vector<Vector2> points;
    for (int y = 0; y < silhouette.height(); ++y)
    {
        for (int x = 0; x < silhouette.width(); ++x)
        {
            for (const Vector2& step : steps)
            {
                if (silhouette.dark(x, y))
                {
                    points.push_back(Vector2(x + 0.5, y + 0.5) + step);
                }
            }
        }
    }
    return points;
}

} // namespace

TEST(ConvexHull, ofASquareWithPointsOnItsSidesHasFourVertices)
{
    const std::vector<Vector2> hull =
        convexHull({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 1}, {1, 2}, {0, 2}, {0, 0.5}});
    EXPECT_EQ(hull.size(), 4u);
    EXPECT_DOUBLE_EQ(polygonArea(hull), 4);
    EXPECT_NEAR((polygonCentroid(hull) - Vector2(1, 1)).norm(), 0, 1e-15);
}

TEST(ConvexOutline, ofARectangleIsTheRectangle)
{
    const Silhouette silhouette =
        test::drawn(9, 7, [](const Vector2& p) { return p.x() > 1 && p.x() < 7 && p.y() > 2 && p.y() < 5; });
    const std::vector<Vector2> outline = convexOutline(silhouette);
    EXPECT_EQ(outline.size(), 4u);
    EXPECT_DOUBLE_EQ(polygonArea(outline), 18);
    EXPECT_NEAR((polygonCentroid(outline) - Vector2(4, 3.5)).norm(), 0, 1e-14);
}

TEST(ConvexOutline, liesOnADiagonalSideHalfWayBetweenRowsOfPixels)
{
    // The rows of centres along the diagonal are 1/sqrt(2) apart; any line between x + y = 20 and 21 gives
    // this picture.
    const Silhouette silhouette = test::drawn(30, 30, [](const Vector2& p) { return p.x() + p.y() < 20.7; });
    double furthest = 0;
    for (const Vector2& vertex : convexOutline(silhouette))
    {
        furthest = std::max(furthest, vertex.x() + vertex.y());
    }
    EXPECT_NEAR(furthest, 20.5, 1e-12);
}

TEST(ConvexOutline, ofOnePixelAndOfAHairHasAnArea)
{
    EXPECT_DOUBLE_EQ(polygonArea(convexOutline(Silhouette(1, 1, {1}))), 1);
    EXPECT_DOUBLE_EQ(polygonArea(convexOutline(Silhouette(5, 1, {1, 1, 1, 1, 1}))), 5);
    const Silhouette diagonal = test::drawn(40, 40, [](const Vector2& p) { return p.x() == p.y(); });
    EXPECT_GT(polygonArea(convexOutline(diagonal)), 20);
}

TEST(ConvexOutline, isConvexAndHoldsThePixelsOfADigitalEllipseAndNoOthers)
{
    test::RandomSource random(11);
    for (int trial = 0; trial < 200; ++trial)
    {
        const test::DrawnEllipse ellipse = test::randomEllipse(3, 60, random);
        const Silhouette silhouette = test::drawn(ellipse.boxSize(), ellipse.boxSize(), ellipse);
        const std::vector<Vector2> outline = convexOutline(silhouette);
        EXPECT_NO_THROW(requireConvex(outline));
        EXPECT_EQ(PixelRegion::differing(PixelRegion(outline), PixelRegion(silhouette)), 0)
            << "trial " << trial;
    }
}

/// The reason for convexOutline: mean relative error of the area for random ellipses.
TEST(ConvexOutline, givesTheLeastBiasedArea)
{
    test::RandomSource random(12);
    const std::vector<Vector2> centre{{0, 0}};
    const std::vector<Vector2> corners{{-0.5, -0.5}, {0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}};
    const std::vector<Vector2> midpoints{{-0.5, 0}, {0.5, 0}, {0, 0.5}, {0, -0.5}};
    constexpr int trials = 400;
    double outlineBias = 0;
    double centreBias = 0;
    double cornerBias = 0;
    double midpointBias = 0;
    for (int trial = 0; trial < trials; ++trial)
    {
        const test::DrawnEllipse ellipse = test::randomEllipse(10, 60, random);
        const Silhouette silhouette = test::drawn(ellipse.boxSize(), ellipse.boxSize(), ellipse);
        const auto error = [&](const std::vector<Vector2>& polygon)
        { return (polygonArea(polygon) / ellipse.area() - 1) / trials; };
        outlineBias += error(convexOutline(silhouette));
        centreBias += error(convexHull(pointsAround(silhouette, centre)));
        cornerBias += error(convexHull(pointsAround(silhouette, corners)));
        midpointBias += error(convexHull(pointsAround(silhouette, midpoints)));
    }
    RecordProperty("outline", std::to_string(outlineBias));
    RecordProperty("centres", std::to_string(centreBias));
    RecordProperty("corners", std::to_string(cornerBias));
    RecordProperty("midpoints", std::to_string(midpointBias));
    EXPECT_LT(std::abs(outlineBias), 0.004);
    for (const double other : {centreBias, cornerBias, midpointBias})
    {
        EXPECT_GT(std::abs(other), 3 * std::abs(outlineBias));
    }
}
