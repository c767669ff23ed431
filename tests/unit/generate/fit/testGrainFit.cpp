#include "generate/fit/grainFit.hpp"

#include "core/base/setupError.hpp"
#include "core/base/tolerances.hpp"
#include "core/io/templateFile.hpp"
#include "generate/fit/fitTables.hpp"
#include "unit/generate/chartShapes.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>

using namespace chesil;

namespace
{

/// The largest angle between tangents at joints that are no corners, which turn by 0.1 rad or more.
double largestSmoothAngle(const PolyBezier& grain)
{
    double largest = 0;
    for (std::size_t i = 0; i < grain.segments().size(); ++i)
    {
        const Vector2 before = grain.segments()[i].endTangent();
        const Vector2 after = grain.segments()[(i + 1) % grain.segments().size()].startTangent();
        const double angle = std::abs(std::atan2(cross(before, after), before.dot(after)));
        largest = angle < 0.1 ? std::max(largest, angle) : largest;
    }
    return largest;
}

constexpr int normals = 10000;

/// For how many of these normals, one after the other, the support points go round counter-clockwise, none of them further
/// out than the support line of the one before.
int convexNormals(const PolyBezier& grain)
{
    Vector2 before = grain.support(Vector2(1, 0));
    for (int i = 1; i <= normals; ++i)
    {
        const double angle = 2 * M_PI * i / normals;
        const Vector2 normal(std::cos(angle), std::sin(angle));
        const Vector2 point = grain.support(normal);
        if (perpendicular(normal).dot(point - before) < -1e-12 * grain.boundingRadius() ||
            normal.dot(before - point) > 1e-12 * grain.boundingRadius())
        {
            return i - 1;
        }
        before = point;
    }
    return normals;
}

/// A rectangle about the middle of a square picture.
Silhouette drawnRectangle(double length, double breadth, double turn)
{
    const int box = static_cast<int>(length * 1.5) + 8;
    const Rotation<2> rotation(turn);
    const Vector2 centre(box / 2.0 + 0.2, box / 2.0 + 0.1);
    return test::drawn(box, box,
                       [&](const Vector2& point)
                       {
                           const Vector2 local = rotation.applyInverse(point - centre);
                           return std::abs(local.x()) <= length / 2 && std::abs(local.y()) <= breadth / 2;
                       });
}

const PolyBezier& polyBezier(const GrainFit& fit) { return std::get<PolyBezier>(fit.grain); }

std::string contentOf(const std::string& path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

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
    ImageGrains image;
    image.grains.assign(2, Silhouette(4, 3, std::vector<std::uint8_t>(12, 1), Vector2(7, 8)));
    EXPECT_EQ(fitGrains("image", image).at(1).name, "grain2");
    image.names = {"pebble", "tile"};
    const std::vector<GrainFit> fits = fitGrains("image", image);
    const std::string path = testing::TempDir() + "fitTable.csv";
    std::string header;
    std::string row;

    writeFitReport(path, fits);
    std::ifstream report(path);
    std::getline(report, header);
    std::getline(report, row);
    EXPECT_EQ(header, "id,pixels,accuracySilhouette,accuracyHull,segments,milliseconds");
    EXPECT_EQ(row.substr(0, row.find(',', 7)), "pebble,12");
    EXPECT_EQ(std::count(row.begin(), row.end(), ','), 5);

    writePlacement(path, fits);
    std::ifstream placement(path);
    std::getline(placement, header);
    std::getline(placement, row);
    std::getline(placement, row);
    EXPECT_EQ(header, "id,x,y,angle");
    double x = 0;
    double y = 0;
    EXPECT_EQ(std::sscanf(row.c_str(), "tile,%lf,%lf", &x, &y), 2);
    EXPECT_NEAR(x, 9, 1e-3);
    EXPECT_NEAR(y, 9.5, 1e-3);

    std::remove(path.c_str());
    EXPECT_THROW(writeFitReport(testing::TempDir() + "noSuchFolder/fit.csv", fits), SetupError);
    EXPECT_THROW(writePlacement(testing::TempDir() + "noSuchFolder/fit.csv", fits), SetupError);
}

TEST(GrainFit, chartOfSphericityAndRoundness)
{
    double least3 = 1;
    double least10 = 1;
    double joint = 0;
    bool convex = true;
    for (const double sphericity : test::chartSphericities())
    {
        for (const double roundness : test::chartRoundnesses())
        {
            const Silhouette shape = test::drawnChartShape(sphericity, roundness);
            for (int segments = 3; segments <= 20; ++segments)
            {
                FitSettings settings;
                settings.segments = segments;
                const GrainFit fit = fitGrain(shape, settings);
                least3 = std::min(least3, fit.accuracySilhouette);
                least10 = segments == 10 ? std::min(least10, fit.accuracySilhouette) : least10;
                joint = std::max(joint, largestSmoothAngle(polyBezier(fit)));
                convex = convex && convexNormals(polyBezier(fit)) == normals;
            }
        }
    }
    EXPECT_GE(least3, 0.90);
    EXPECT_GE(least10, 0.985);
    EXPECT_LE(joint, tolerances::joint);
    EXPECT_TRUE(convex);
    test::record("grainsFromImages", "leastChartAccuracy3", least3, "-");
    test::record("grainsFromImages", "leastChartAccuracy10Convex", least10, "-");
}

TEST(GrainFit, slenderGrainsKeepTheirThickness)
{
    for (const double ratio : {10.0, 50.0})
    {
        for (const double turn : {0.0, 0.1, 0.3})
        {
            const test::DrawnEllipse ellipse{Vector2(603, 603.3), 600, 600 / ratio, Rotation<2>(turn)};
            const GrainFit fit = fitGrain(test::drawn(ellipse.boxSize(), ellipse.boxSize(), ellipse));
            EXPECT_NEAR(polyBezier(fit).massProperties().area / ellipse.area(), 1, 0.004)
                << ratio << " " << turn;
            EXPECT_GE(fit.accuracyHull, 0.995) << ratio << " " << turn;
            EXPECT_LE(largestSmoothAngle(polyBezier(fit)), tolerances::joint);
            const GrainFit plank = fitGrain(drawnRectangle(1200, 1200 / ratio, turn));
            EXPECT_GE(plank.accuracyHull, 0.999) << ratio << " " << turn;
        }
    }
}

TEST(GrainFit, squareAndHalfDiskHaveTheirCorners)
{
    for (const double turn : {0.0, 0.2, 0.7})
    {
        const GrainFit square = fitGrain(drawnRectangle(200, 200, turn));
        EXPECT_EQ(square.segments, 4);
        EXPECT_NEAR(polyBezier(square).boundingRadius(), 100 * std::sqrt(2.0), 0.7);
        EXPECT_TRUE(polyBezier(square).hasStraightSides());

        const Rotation<2> rotation(turn);
        const Silhouette halfDisk = test::drawn(440, 440,
                                                [&](const Vector2& point)
                                                {
                                                    const Vector2 local =
                                                        rotation.applyInverse(point - Vector2(220, 220));
                                                    return local.norm() <= 200 && local.y() >= 0;
                                                });
        const GrainFit fit = fitGrain(halfDisk);
        int corners = 0;
        for (std::size_t i = 0; i < polyBezier(fit).segments().size(); ++i)
        {
            const auto& segments = polyBezier(fit).segments();
            const Vector2 before = segments[i].endTangent().normalized();
            const Vector2 after = segments[(i + 1) % segments.size()].startTangent().normalized();
            const double angle = std::atan2(cross(before, after), before.dot(after));
            corners += angle > 0.1;
            EXPECT_TRUE(angle < tolerances::joint || std::abs(angle - M_PI / 2) < 0.1) << angle;
        }
        EXPECT_EQ(corners, 2);
        EXPECT_GE(fit.accuracyHull, 0.998);
    }
}

TEST(GrainFit, addsSegmentsUntilTheAccuracyIsReachedOrSaysSo)
{
    FitSettings settings;
    settings.segments = mostSegments;
    int before = 0;
    for (const double accuracy : {0.9, 0.98, 0.995})
    {
        settings.accuracy = accuracy;
        const GrainFit fit = fitGrain(test::drawnChartShape(0.5, 0.3), settings);
        EXPECT_GE(fit.accuracyHull, accuracy);
        EXPECT_TRUE(fit.reachedAccuracy);
        EXPECT_GE(fit.segments, before);
        EXPECT_LE(fit.segments, 10);
        before = fit.segments;
    }
    settings.segments = 4;
    const GrainFit poor = fitGrain(test::drawnChartShape(0.5, 0.3), settings);
    EXPECT_LT(poor.accuracyHull, 0.995);
    EXPECT_FALSE(poor.reachedAccuracy);
    EXPECT_EQ(poor.segments, 4);
}

TEST(GrainFit, polygonAndEllipseOfTheSameOutline)
{
    const test::DrawnEllipse ellipse{Vector2(110, 110.3), 100, 40, Rotation<2>(0.7)};
    const Silhouette shape = test::drawn(ellipse.boxSize() + 20, ellipse.boxSize() + 20, ellipse);
    FitSettings settings;
    settings.model = GrainModel::ellipse;
    const GrainFit same = fitGrain(shape, settings);
    EXPECT_NEAR(std::get<Ellipse>(same.grain).a(), 100, 0.3);
    EXPECT_NEAR(std::get<Ellipse>(same.grain).b(), 40, 0.3);
    EXPECT_NEAR(same.angle, 0.7, 0.005);
    EXPECT_GE(same.accuracyHull, 0.99);

    settings.model = GrainModel::polygon;
    double before = 0;
    for (const int sides : {3, 5, 10, 20})
    {
        settings.segments = sides;
        const GrainFit polygon = fitGrain(shape, settings);
        EXPECT_LE(std::get<ConvexPolygon>(polygon.grain).vertices().size(), static_cast<std::size_t>(sides));
        EXPECT_GT(polygon.accuracyHull, before) << sides;
        before = polygon.accuracyHull;
    }
    EXPECT_GE(before, 0.99);
    EXPECT_GT(fitGrain(shape).accuracyHull, 0.995);
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
    const std::clock_t start = std::clock();
    const ImageGrains image = readGrains(path);
    EXPECT_GT(image.grains.size(), 300u);
    std::vector<GrainFit> fits;
    for (std::size_t i = 0; i < image.grains.size(); ++i)
    {
        try
        {
            fits.push_back(fitGrain(image.grains[i]));
        }
        catch (const ValueError& error)
        {
            ADD_FAILURE() << grainName(i) << ": " << error.what();
        }
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;

    std::vector<double> toSilhouette;
    std::vector<double> toHull;
    double joint = 0;
    int seen = normals;
    TemplateFile templates;
    for (const GrainFit& fit : fits)
    {
        EXPECT_GE(fit.pixels, 200);
        joint = std::max(joint, largestSmoothAngle(polyBezier(fit)));
        seen = std::min(seen, convexNormals(polyBezier(fit)));
        templates.grains.push_back({grainName(templates.grains.size()), fit.grain});
        EXPECT_GE(fit.accuracyHull, 0.95);
        toSilhouette.push_back(fit.accuracySilhouette);
        toHull.push_back(fit.accuracyHull);
    }
    FitSettings inMetres;
    inMetres.scale = 1e-4;
    for (const GrainFit& fit : fitGrains(path, image, inMetres))
    {
        joint = std::max(joint, largestSmoothAngle(polyBezier(fit)));
    }
    EXPECT_LE(joint, tolerances::joint);
    EXPECT_EQ(seen, normals);
    EXPECT_GE(median(toHull), 0.985);
    EXPECT_GE(median(toSilhouette), 0.96);

    const std::string first = testing::TempDir() + "pebbles1.chesil";
    const std::string second = testing::TempDir() + "pebbles2.chesil";
    writeTemplates(first, templates);
    writeTemplates(second, readTemplates(first));
    const bool identical = contentOf(first) == contentOf(second);
    EXPECT_TRUE(identical);
    std::remove(first.c_str());
    std::remove(second.c_str());

    const auto record = [](const char* name, double value, const char* unit)
    { test::record("grainsFromImages", name, value, unit); };
    record("pebblesMedianHull", median(toHull), "-");
    record("pebblesMedianSilhouette", median(toSilhouette), "-");
    record("pebblesFailed", static_cast<double>(image.grains.size() - fits.size()), "grains");
    record("pebblesSeconds", seconds, "s");
    record("g1Error", joint, "rad");
    record("convexNormals", seen, "normals");
    record("templateRoundTrip", identical ? 1 : 0, "-");
}
