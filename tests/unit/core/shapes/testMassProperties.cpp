#include "core/shapes/shape.hpp"

#include "core/base/setupError.hpp"
#include "unit/knownShapes.hpp"
#include "unit/preciseCurve.hpp"
#include "unit/randomGrain.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace chesil;

namespace
{

struct Known
{
    double area;
    double polarMoment;
    Vector2 centroid;
};

/// Largest relative error of area, moment and centroid (over the size) of a grain given off its centroid.
double largestError(const PolyBezier& grain, const Known& known)
{
    const MassProperties mass = grain.massProperties();
    return std::max({std::abs(mass.area / known.area - 1), std::abs(mass.polarMoment / known.polarMoment - 1),
                     (grain.givenCentroid() - known.centroid).norm() / std::sqrt(known.area)});
}

const Vector2 centre(0.75, -0.5);

} // namespace

TEST(MassProperties, polyBezierSquare)
{
    const PolyBezier grain(test::polygonSegments(test::rectangleVertices(2, 2, centre)));
    const double error = largestError(grain, {4, 8.0 / 3, centre});
    EXPECT_LE(error, 1e-14);
    test::record("firstLight", "massPropertiesSquareError", error, "-");
}

// 32 segments with exact ends, tangents and middles: the radius errs by 1e-9 at most, outwards.
TEST(MassProperties, polyBezierCircle)
{
    const PolyBezier grain(test::ellipseSegments(32, 2, 2, centre));
    const double error = largestError(grain, {4 * M_PI, 8 * M_PI, centre});
    EXPECT_LE(error, 1e-8);
    test::record("firstLight", "massPropertiesCircleError", error, "-");
}

TEST(MassProperties, polyBezierEllipse)
{
    const PolyBezier grain(test::ellipseSegments(32, 3, 0.5, centre));
    const double error = largestError(grain, {1.5 * M_PI, 1.5 * M_PI * (9 + 0.25) / 4, centre});
    EXPECT_LE(error, 1e-8);
    test::record("firstLight", "massPropertiesEllipseError", error, "-");
}

TEST(MassProperties, ofACircleConvergeWithTheSixthPowerOfTheSegments)
{
    const auto errorWith = [](int segments)
    { return PolyBezier(test::ellipseSegments(segments, 1, 1)).massProperties().area / M_PI - 1; };
    EXPECT_NEAR(std::log2(errorWith(4) / errorWith(8)), 6, 0.2);
    EXPECT_NEAR(std::log2(errorWith(8) / errorWith(16)), 6, 0.2);
}

TEST(MassProperties, ofRandomGrainsAsInLongDouble)
{
    test::RandomSource random(71);
    for (int i = 0; i < 200; ++i)
    {
        test::RandomGrainOptions options;
        options.segments = random.integer(4, 20);
        options.radius = random.logUniform(1e-4, 1e3);
        options.waviness = random.uniform(0, 0.95);
        const std::vector<CubicBezier> segments = test::randomSegments(options, random);
        const PolyBezier grain(segments);
        const test::PreciseMoments expected = test::preciseMoments(segments);
        const auto size = std::sqrt(expected.area);
        EXPECT_LE(std::abs(grain.massProperties().area / expected.area - 1), 1e-13L);
        EXPECT_LE(std::abs(grain.massProperties().polarMoment / expected.polarAboutCentroid() - 1), 1e-13L);
        EXPECT_LE(std::abs(grain.givenCentroid().x() - expected.first.x / expected.area) / size, 1e-13L);
        EXPECT_LE(std::abs(grain.givenCentroid().y() - expected.first.y / expected.area) / size, 1e-13L);
        // And the segments kept are about the centroid.
        const test::PreciseMoments kept = test::preciseMoments(grain.segments());
        EXPECT_LE(std::hypot(kept.first.x, kept.first.y) / kept.area / size, 1e-13L);
    }
}

TEST(MassProperties, ofTheOtherShapes)
{
    EXPECT_DOUBLE_EQ(Circle(2).massProperties().area, 4 * M_PI);
    EXPECT_DOUBLE_EQ(Circle(2).massProperties().polarMoment, 8 * M_PI);
    EXPECT_DOUBLE_EQ(Ellipse(3, 2).massProperties().area, 6 * M_PI);
    EXPECT_DOUBLE_EQ(Ellipse(3, 2).massProperties().polarMoment, 6 * M_PI * 13 / 4);
    const ConvexPolygon triangle({{1, 1}, {4, 1}, {1, 5}});
    EXPECT_NEAR(triangle.massProperties().area, 6, 1e-14);
    // Sum of the squared sides over 36 times the area.
    EXPECT_NEAR(triangle.massProperties().polarMoment, 6 * (9 + 16 + 25) / 36.0, 1e-13);
    EXPECT_LT((triangle.givenCentroid() - Vector2(2, 7.0 / 3)).norm(), 1e-15);
}

TEST(MassProperties, impossibleSizesAreRefused)
{
    for (const double bad :
         {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    {
        EXPECT_THROW(Circle{bad}, ValueError) << bad;
        EXPECT_THROW(Ellipse(1, bad), ValueError) << bad;
        EXPECT_THROW(Ellipse(bad, 1), ValueError) << bad;
    }
    EXPECT_THROW(ConvexPolygon({{0, 0}, {1, 0}}), ValueError);
    EXPECT_THROW(ConvexPolygon({{0, 0}, {1, 1}, {2, 2}}), ValueError);
    EXPECT_THROW(ConvexPolygon({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), ValueError);
}
