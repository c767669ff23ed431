#include "generate/fit/grainFit.hpp"

#include "core/base/setupError.hpp"
#include "core/base/tolerances.hpp"
#include "generate/fit/fitTables.hpp"
#include "unit/generate/drawnShapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

using namespace chesil;

namespace
{

const PolyBezier& polyBezier(const GrainFit& fit) { return std::get<PolyBezier>(fit.grain); }

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

} // namespace

TEST(GrainFit, drawnEllipsesAreFittedAlmostToThePixel)
{
    test::RandomSource random(41);
    for (int trial = 0; trial < 200; ++trial)
    {
        // 100 pixels, about, to the size of the shapes in Lai & Huang's chart
        const test::DrawnEllipse ellipse = test::randomEllipse(9, 200, random);
        const GrainFit fit = fitGrain(test::drawn(ellipse.boxSize(), ellipse.boxSize(), ellipse));
        EXPECT_GE(fit.accuracySilhouette, 0.985) << "half-axes " << ellipse.a << " " << ellipse.b;
        EXPECT_GE(fit.accuracyHull, 0.985);
        EXPECT_LE(polyBezier(fit).largestJointAngle(), tolerances::joint);
        EXPECT_NEAR(polyBezier(fit).massProperties().area / ellipse.area(), 1, 2.5 / std::sqrt(fit.pixels));
        EXPECT_NEAR((fit.centroid - ellipse.centre).norm(), 0, 0.5);
    }
}

TEST(GrainFit, keepsPlaceTurnAndScale)
{
    const test::DrawnEllipse ellipse{Vector2(50, 50), 40, 20, Rotation<2>(0.4)};
    const Silhouette centred = test::drawn(100, 100, ellipse);
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < 100; ++y)
    {
        for (int x = 0; x < 100; ++x)
        {
            pixels.push_back(centred.dark(x, y) ? 1 : 0);
        }
    }
    FitSettings settings;
    settings.scale = 1e-3;
    const GrainFit fit = fitGrain(Silhouette(100, 100, pixels, Vector2(300, 200)), settings);
    EXPECT_NEAR((fit.centroid - Vector2(0.35, 0.25)).norm(), 0, 1e-4);
    const Vector2 longAxis(std::cos(0.4), std::sin(0.4));
    EXPECT_NEAR(longAxis.dot(polyBezier(fit).support(longAxis)), 0.040, 2e-4);
    EXPECT_NEAR(polyBezier(fit).boundingRadius(), 0.040, 1e-3);
}

TEST(GrainFit, coversTheHollowOfACrescentAndSaysSo)
{
    const Silhouette crescent =
        test::drawn(80, 80,
                    [](const Vector2& p)
                    { return (p - Vector2(40, 40)).norm() < 35 && (p - Vector2(60, 40)).norm() > 30; });
    const GrainFit fit = fitGrain(crescent);
    EXPECT_LT(fit.accuracySilhouette, 0.7);
    EXPECT_GT(fit.accuracyHull, 0.97);
}

TEST(GrainFit, takesOnePixelAndAHair)
{
    EXPECT_LE(polyBezier(fitGrain(Silhouette(1, 1, {1}))).largestJointAngle(), tolerances::joint);
    const GrainFit hair = fitGrain(Silhouette(200, 1, std::vector<std::uint8_t>(200, 1)));
    // No outline is thinner than about a hundredth of its length (leastHandle in smoothOutline.cpp).
    EXPECT_GT(polyBezier(hair).massProperties().area, 190);
    EXPECT_LT(polyBezier(hair).massProperties().area, 400);
    EXPECT_LE(polyBezier(hair).largestJointAngle(), tolerances::joint);
}

TEST(GrainFit, settingsOutOfRangeAreNamed)
{
    const auto with = [](int segments, double scale)
    {
        FitSettings settings;
        settings.segments = segments;
        settings.scale = scale;
        return settings;
    };
    const auto entryRefused = [](const FitSettings& settings)
    {
        try
        {
            fitGrains("pebbles.png", {}, settings);
        }
        catch (const SetupError& error)
        {
            EXPECT_EQ(error.file(), "pebbles.png");
            return error.entry();
        }
        return std::string("none");
    };
    EXPECT_EQ(entryRefused(with(2, 1)), "segments");
    EXPECT_EQ(entryRefused(with(65, 1)), "segments");
    for (const double scale :
         {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
        EXPECT_EQ(entryRefused(with(10, scale)), "scale");
    }
    EXPECT_EQ(entryRefused(with(10, 1)), "none");
}

TEST(FitTables, haveTheirHeaderAndOneRowAGrain)
{
    const std::vector<GrainFit> fits(
        2, fitGrain(Silhouette(4, 3, std::vector<std::uint8_t>(12, 1), Vector2(7, 8))));
    const std::string path = testing::TempDir() + "fitTable.csv";
    std::string header;
    std::string row;

    writeFitReport(path, fits);
    std::ifstream report(path);
    std::getline(report, header);
    std::getline(report, row);
    EXPECT_EQ(header, "id,pixels,accuracySilhouette,accuracyHull,segments,milliseconds");
    EXPECT_EQ(row.substr(0, row.find(',', 7)), "grain1,12");
    EXPECT_EQ(std::count(row.begin(), row.end(), ','), 5);

    writePlacement(path, fits);
    std::ifstream placement(path);
    std::getline(placement, header);
    std::getline(placement, row);
    std::getline(placement, row);
    EXPECT_EQ(header, "id,x,y,angle");
    double x = 0;
    double y = 0;
    EXPECT_EQ(std::sscanf(row.c_str(), "grain2,%lf,%lf", &x, &y), 2);
    EXPECT_NEAR(x, 9, 1e-3);
    EXPECT_NEAR(y, 9.5, 1e-3);

    std::remove(path.c_str());
    EXPECT_THROW(writeFitReport(testing::TempDir() + "noSuchFolder/fit.csv", fits), SetupError);
    EXPECT_THROW(writePlacement(testing::TempDir() + "noSuchFolder/fit.csv", fits), SetupError);
}

TEST(GrainFit, realPebblesOfTorreyPines)
{
    const char* project = std::getenv("CHESIL_DIR");
    const std::string path =
        std::string(project ? project : ".") + "/../shared/data/torrey_pines_pebbles.png";
    if (!std::ifstream(path))
    {
        GTEST_SKIP() << "the photo is not beside this clone: " << path;
    }
    const ImageGrains image = readGrains(path);
    EXPECT_GT(image.grains.size(), 300u);
    const std::vector<GrainFit> fits = fitGrains(path, image);
    ASSERT_EQ(fits.size(), image.grains.size());

    std::vector<double> toSilhouette;
    std::vector<double> toHull;
    for (const GrainFit& fit : fits)
    {
        EXPECT_GE(fit.pixels, 200);
        EXPECT_LE(polyBezier(fit).largestJointAngle(), tolerances::joint);
        EXPECT_GE(fit.accuracyHull, 0.95);
        toSilhouette.push_back(fit.accuracySilhouette);
        toHull.push_back(fit.accuracyHull);
    }
    EXPECT_GE(median(toHull), 0.985);
    EXPECT_GE(median(toSilhouette), 0.96);
}
