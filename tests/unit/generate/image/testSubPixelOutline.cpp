#include "generate/image/convexHull.hpp"
#include "generate/image/silhouetteReader.hpp"
#include "unit/generate/greyPicture.hpp"
#include "unit/randomGrain.hpp"
#include "unit/temporaryFolder.hpp"

#include <algorithm>

using namespace chesil;

namespace
{

/// Mean errors of 40 disks: area relative, centroid in pixels.
struct Errors
{
    double area = 0;
    double centroid = 0;

    void add(double radius, double measuredArea, const Vector2& centre, const Vector2& measuredCentre)
    {
        area += std::abs(measuredArea / (M_PI * radius * radius) - 1) / 40;
        centroid += (measuredCentre - centre).norm() / 40;
    }
};

Vector2 pixelCentroid(const Silhouette& grain)
{
    Vector2 sum = Vector2::Zero();
    for (int y = 0; y < grain.height(); ++y)
    {
        for (int x = 0; x < grain.width(); ++x)
        {
            sum += grain.dark(x, y) ? Vector2(x + 0.5, y + 0.5) : Vector2(0, 0);
        }
    }
    return sum / grain.count();
}

class SubPixelOutline : public test::TemporaryFolder
{
protected:
    ImageGrains read(const test::GreyPicture& picture, const ImageSettings& settings = {})
    {
        const std::string path = folder_ + "/picture.pgm";
        picture.write(path);
        return readGrains(path, settings);
    }
};

} // namespace

/// The reason for it. Measured (radius: pixels, their convex outline, sub-pixel outline):
/// area 5: 0.0142 0.0159 0.0027, 12: 0.0038 0.0047 0.0008, 50: 0.0004 0.0008 0.0001;
/// centroid [pixel] 5: 0.102 0.091 0.021, 12: 0.058 0.052 0.013, 50: 0.031 0.028 0.006.
TEST_F(SubPixelOutline, ofSmoothDisksHasThreeTimesBetterAreasAndCentroids)
{
    for (const double radius : {5., 8., 12., 20., 50.})
    {
        test::RandomSource random(5);
        const int cell = static_cast<int>(2 * radius) + 8;
        test::GreyPicture picture(8 * cell, 5 * cell, 220);
        std::vector<Vector2> centres;
        for (int i = 0; i < 40; ++i)
        {
            centres.emplace_back((i % 8 + 0.5) * cell + random.uniform(-0.5, 0.5),
                                 (i / 8 + 0.5) * cell + random.uniform(-0.5, 0.5));
            picture.disk(centres.back(), radius, 30);
        }
        ImageSettings settings;
        settings.minPixels = 20;
        const ImageGrains image = read(picture, settings);
        ASSERT_EQ(image.grains.size(), 40u);
        Errors pixels;
        Errors hull;
        Errors outline;
        for (const Silhouette& grain : image.grains)
        {
            const auto distance = [&](const Vector2& centre) {
                return (Vector2(centre.x(), image.height - centre.y()) - grain.corner() -
                        pixelCentroid(grain))
                    .norm();
            };
            Vector2 centre = *std::min_element(centres.begin(), centres.end(),
                                               [&](auto& a, auto& b) { return distance(a) < distance(b); });
            centre = Vector2(centre.x(), image.height - centre.y()) - grain.corner();
            const std::vector<Vector2> convex = convexOutline(grain);
            ASSERT_FALSE(grain.outline().empty());
            pixels.add(radius, grain.count(), centre, pixelCentroid(grain));
            hull.add(radius, polygonArea(convex), centre, polygonCentroid(convex));
            outline.add(radius, polygonArea(grain.outline()), centre, polygonCentroid(grain.outline()));
        }
        RecordProperty("areas" + std::to_string(int(radius)), std::to_string(pixels.area) + " " +
                                                                  std::to_string(hull.area) + " " +
                                                                  std::to_string(outline.area));
        RecordProperty("centroids" + std::to_string(int(radius)), std::to_string(pixels.centroid) + " " +
                                                                      std::to_string(hull.centroid) + " " +
                                                                      std::to_string(outline.centroid));
        for (const Errors& other : {pixels, hull})
        {
            EXPECT_LT(3 * outline.centroid, other.centroid) << radius;
            EXPECT_LT((radius < 20 ? 3 : 2) * outline.area, other.area) << radius;
        }
    }
}

TEST_F(SubPixelOutline, ofALinearRampLiesWhereTheLevelDoes)
{
    // Grey falls by 20 a pixel towards the grain: 210, 190, ..., 30 at centres; level 100.5 lies between 110
    // and 90.
    test::GreyPicture picture(60, 60, 210);
    for (int ring = 0; ring < 10; ++ring)
    {
        picture.box(10 + ring, 10 + ring, 40 - 2 * ring, 40 - 2 * ring, 210 - 20 * ring);
    }
    ImageSettings settings;
    settings.threshold = 100;
    const ImageGrains image = read(picture, settings);
    ASSERT_EQ(image.grains.size(), 1u);
    const std::vector<Vector2>& outline = image.grains[0].outline();
    ASSERT_EQ(outline.size(), 4u * 28u);
    double least = 1e9;
    double most = -1e9;
    for (const Vector2& vertex : outline)
    {
        least = std::min(least, vertex.x());
        most = std::max(most, vertex.x());
    }
    // Pixels of 90 are the grain's first; from their centre it is (100.5 - 90)/20 of a pixel outward.
    EXPECT_NEAR(least, 0.5 - 10.5 / 20, 1e-12);
    EXPECT_NEAR(most, 27.5 + 10.5 / 20, 1e-12);
    EXPECT_GT(polygonArea(outline), 0) << "not counter-clockwise";
}

TEST_F(SubPixelOutline, isTheSameForLightGrains)
{
    test::GreyPicture dark(60, 60, 220);
    test::GreyPicture light(60, 60, 35);
    dark.disk({30.2, 29.7}, 17.3, 30);
    light.disk({30.2, 29.7}, 17.3, 225);
    ImageSettings settings;
    settings.threshold = 125;
    const ImageGrains first = read(dark, settings);
    settings.threshold = 255 - 125 - 1;
    settings.lightGrains = true;
    const ImageGrains second = read(light, settings);
    ASSERT_EQ(first.grains.size(), 1u);
    ASSERT_EQ(second.grains.size(), 1u);
    const std::vector<Vector2>& a = first.grains[0].outline();
    const std::vector<Vector2>& b = second.grains[0].outline();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        // Grey values were rounded to different sides.
        EXPECT_NEAR((a[i] - b[i]).norm(), 0, 0.01);
    }
}

TEST_F(SubPixelOutline, isEmptyWhereGreyValuesKnowNothingFiner)
{
    test::GreyPicture binary(60, 60, 255);
    binary.disk({30.2, 29.7}, 17.3, 0, false);
    test::GreyPicture drawn(120, 60, 220);
    drawn.disk({30.2, 29.7}, 17.3, 90, false).disk({90.2, 29.7}, 17.3, 100, false).box(0, 50, 5, 5, 210);
    EXPECT_TRUE(read(binary).grains.at(0).outline().empty());
    EXPECT_TRUE(read(drawn).grains.at(0).outline().empty());
    EXPECT_TRUE(read(drawn).grains.at(1).outline().empty());
}

TEST_F(SubPixelOutline, goesIntoHollowsAndDoesNotJoinPixelsAtCorners)
{
    test::GreyPicture slit(100, 100, 220);
    slit.disk({40.3, 60.1}, 25, 30).box(38, 0, 4, 60, 220);
    const ImageGrains first = read(slit);
    ASSERT_EQ(first.grains.size(), 1u);
    EXPECT_NEAR(polygonArea(first.grains[0].outline()), first.grains[0].count(),
                0.01 * first.grains[0].count());

    // A hollow that opens to the outside where two of the grain's pixels share a corner.
    test::GreyPicture corner(60, 60, 220);
    corner.box(9, 9, 42, 42, 150).box(10, 10, 40, 40, 30).box(37, 37, 12, 12, 150).box(49, 49, 1, 1, 150);
    const ImageGrains second = read(corner);
    ASSERT_EQ(second.grains.size(), 1u);
    EXPECT_EQ(second.holesFilled, 0);
    EXPECT_EQ(second.grains[0].count(), 1600 - 144 - 1);
    EXPECT_NEAR(polygonArea(second.grains[0].outline()), 1600 - 144 - 1, 60);
}

TEST_F(SubPixelOutline, holdsAHalfWayLineWhereASplitGrainWasCut)
{
    test::GreyPicture picture(140, 80, 220);
    picture.disk({45, 40}, 25, 30).disk({91, 40}, 25, 30);
    ImageSettings settings;
    settings.split = true;
    const ImageGrains image = read(picture, settings);
    ASSERT_EQ(image.grains.size(), 2u);
    for (const Silhouette& grain : image.grains)
    {
        EXPECT_NEAR(polygonArea(grain.outline()), M_PI * 25 * 25, 0.03 * M_PI * 25 * 25);
    }
}
