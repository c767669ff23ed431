#include "generate/image/outlineFile.hpp"

#include "core/base/setupError.hpp"
#include "generate/image/convexHull.hpp"
#include "generate/image/silhouetteReader.hpp"
#include "unit/temporaryFolder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

using namespace chesil;
using testing::HasSubstr;

namespace
{

class OutlineFiles : public test::TemporaryFolder
{
protected:
    std::string saved(const std::string& name, const std::string& content)
    {
        test::setContent(folder_ + "/" + name, content);
        return folder_ + "/" + name;
    }

    std::string csvRefusal(const std::string& content)
    {
        const std::string path = saved("outlines.csv", content);
        const auto error = test::errorOf<SetupError>([&] { readCsvOutlines(path); });
        EXPECT_EQ(error.file(), path);
        return error.entry() + ": " + error.found() + "; " + error.expected();
    }

    std::string jsonRefusal(const std::string& content)
    {
        const std::string path = saved("outlines.geojson", content);
        const auto error = test::errorOf<SetupError>([&] { readGeoJsonOutlines(path); });
        EXPECT_EQ(error.file(), path);
        return error.entry() + ": " + error.found() + "; " + error.expected();
    }
};

using OutlineGrains = OutlineFiles;

const std::string square = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";

std::string feature(const std::string& geometry)
{
    return R"({"type":"Feature","properties":{},"geometry":)" + geometry + "}";
}

std::string polygon(const std::string& rings)
{
    return R"({"type":"Polygon","coordinates":[)" + rings + "]}";
}

} // namespace

TEST_F(OutlineFiles, csvGivesOutlinesCounterClockwiseOnce)
{
    // Columns in any order, one more, blanks, a comment, a closed outline, one that runs clockwise.
    const OutlineFile file =
        readCsvOutlines(saved("a.csv", "y, note ,x,id\n"
                                       "0,a,0,first one\n0,a,2,first one\n1,a,2,first one\n"
                                       "1,a,0,first one\n0,a,0,first one\n"
                                       "# the second\n"
                                       "0,,0,2\r\n5,,0,2\r\n0,,-1.5e0,2\r\n"));
    ASSERT_EQ(file.outlines.size(), 2u);
    EXPECT_EQ(file.outlines[0], (std::vector<Vector2>{{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
    EXPECT_DOUBLE_EQ(polygonArea(file.outlines[1]), 3.75);
}

TEST_F(OutlineFiles, csvThatIsWrongIsRefusedByLine)
{
    EXPECT_THAT(csvRefusal("id,x\n1,0\n"),
                HasSubstr("no column 'y'; a header line with the columns id, x, y"));
    EXPECT_THAT(csvRefusal(""), HasSubstr("the columns id, x, y"));
    EXPECT_THAT(csvRefusal("id,x,y\n"), HasSubstr("a row a vertex"));
    EXPECT_THAT(csvRefusal("id,x,y\n1,0,0\n1,1,0\n2,0,0\n2,1,0\n2,1,1\n"),
                AllOf(HasSubstr("line 2: "), HasSubstr("an outline of 2 different points (id 1)")));
    EXPECT_THAT(csvRefusal("id,x,y\n1,0,0\n1,1,0\n1,0,0\n"), HasSubstr("2 different points"));
    EXPECT_THAT(csvRefusal("id,x,y\n7,0,0\n7,1,1\n7,1,0\n7,0,1\n"),
                HasSubstr("crosses or touches itself (id 7); a simple polygon"));
    EXPECT_THAT(csvRefusal("id,x,y\n7,0,0\n7,1,1\n7,2,2\n"), HasSubstr("itself (id 7)"));
    EXPECT_THAT(csvRefusal("id,x,y\n1,0,0\n1,1\n"), AllOf(HasSubstr("line 3: "), HasSubstr("2 fields")));
    EXPECT_THAT(csvRefusal("id,x,y\n1,0,0\n1,one,1\n"), AllOf(HasSubstr("line 3: "), HasSubstr("one")));
    EXPECT_THAT(csvRefusal("id,x,y\n1,0,nan\n"), HasSubstr("nan"));
    EXPECT_THAT(csvRefusal("id,x,y\n1,0,0\n1,1,0\n1,1,1\n2,0,0\n2,1,0\n2,1,1\n1,5,5\n"),
                AllOf(HasSubstr("line 8: "), HasSubstr("id '1' again")));
    const auto missing = test::errorOf<SetupError>([&] { readCsvOutlines(folder_ + "/none.csv"); });
    EXPECT_THAT(missing.what(), HasSubstr("none.csv"));
}

TEST_F(OutlineFiles, geoJsonGivesEachPolygon)
{
    const std::string hole = "[[1,1],[1,2],[2,2],[2,1],[1,1]]";
    const OutlineFile file = readGeoJsonOutlines(
        saved("a.geojson", R"({"type":"FeatureCollection","features":[)" +
                               feature(polygon(square + "," + hole)) + "," +
                               feature(R"({"type":"MultiPolygon","coordinates":[[)" + square +
                                       R"(],[[[9,9,1],[9,8,1],[8,8,1],[9,9,1]]]]})") +
                               "]}"));
    ASSERT_EQ(file.outlines.size(), 3u);
    EXPECT_EQ(file.holes, 1);
    EXPECT_DOUBLE_EQ(polygonArea(file.outlines[0]), 16);
    EXPECT_DOUBLE_EQ(polygonArea(file.outlines[2]), 0.5);
    EXPECT_EQ(readGeoJsonOutlines(saved("b.json", feature(polygon(square)))).outlines.size(), 1u);
    EXPECT_EQ(readGeoJsonOutlines(saved("c.json", polygon(square))).outlines.size(), 1u);
}

TEST_F(OutlineFiles, geoJsonThatIsWrongIsRefusedByFeature)
{
    const auto collection = [](const std::string& features)
    { return R"({"type":"FeatureCollection","features":[)" + features + "]}"; };
    EXPECT_THAT(jsonRefusal(collection("")),
                HasSubstr("no polygon; features that are Polygon or MultiPolygon"));
    EXPECT_THAT(jsonRefusal(collection(feature(polygon(square)) + "," +
                                       feature(R"({"type":"Point","coordinates":[1,2]})"))),
                HasSubstr("feature 2: Point; "));
    EXPECT_THAT(jsonRefusal(collection(feature("null"))), HasSubstr("feature 1: no geometry"));
    EXPECT_THAT(jsonRefusal(feature(polygon(""))), HasSubstr("without points"));
    EXPECT_THAT(jsonRefusal(polygon("[[0,0],[1,1],[1,0],[0,1]]")), HasSubstr("crosses"));
    EXPECT_THAT(jsonRefusal(polygon("[[0,0],[1,1],[0,0]]")), HasSubstr("2 different points"));
    EXPECT_THAT(jsonRefusal(polygon("[[0],[1],[2]]")), HasSubstr("1 numbers"));
    EXPECT_THAT(jsonRefusal(polygon(R"([[0,0],["one",1],[0,1]])")), HasSubstr("'one'"));
    EXPECT_THAT(jsonRefusal(polygon("[[0,0],[1e999,1],[0,1]]")), HasSubstr("coordinate"));
    EXPECT_THAT(jsonRefusal("{}"), HasSubstr("no geometry"));
    EXPECT_THAT(jsonRefusal("[1, 2]"), HasSubstr("no geometry"));
    EXPECT_THAT(jsonRefusal(R"({"type":"FeatureColl)"), HasSubstr("line 1"));
    EXPECT_THAT(jsonRefusal(""), HasSubstr("an empty file"));
    const auto missing = test::errorOf<SetupError>([&] { readGeoJsonOutlines(folder_ + "/none.json"); });
    EXPECT_THAT(missing.found(), HasSubstr("No such file"));
}

TEST_F(OutlineGrains, areDrawnFourHundredPixelsAcrossWithTheirExactOutline)
{
    // Millimetres far from the origin; an ellipse and one of twice its size.
    std::ostringstream csv;
    csv.precision(17);
    csv << "id,x,y\n";
    for (const double size : {1., 1., 2.})
    {
        static int id = 0;
        ++id;
        for (int i = 0; i < 100; ++i)
        {
            csv << id << ',' << 5e-3 * size * std::cos(2 * M_PI * i / 100) + 1234.5 << ','
                << 3e-3 * size * std::sin(2 * M_PI * i / 100) - 77 << '\n';
        }
    }
    const ImageGrains image = readGrains(saved("grains.CSV", csv.str()));
    EXPECT_EQ(image.kind, ImageKind::outlines);
    ASSERT_EQ(image.grains.size(), 3u);
    EXPECT_NEAR(image.pixelSize, 10e-3 / 400, 1e-10);
    EXPECT_EQ(image.grains[0].width(), 400 + 1);
    EXPECT_NEAR(image.grains[2].width(), 800, 1);
    for (const Silhouette& grain : image.grains)
    {
        EXPECT_EQ(grain.outline().size(), 100u);
        EXPECT_NEAR(grain.count() / polygonArea(grain.outline()), 1, 1e-3);
        const Vector2 centre = image.pixelSize * (grain.corner() + polygonCentroid(grain.outline()));
        EXPECT_NEAR((centre - Vector2(1234.5, -77)).norm(), 0, 1e-9);
    }
}

TEST_F(OutlineGrains, ofAWholeMapAreRefused)
{
    const std::string path = saved("map.csv", "id,x,y\n1,0,0\n1,1,0\n1,0,1\n2,5,0\n2,6,0\n2,5,1\n"
                                              "3,0,0\n3,1000,0\n3,1000,1000\n");
    const auto error = test::errorOf<SetupError>([&] { readGrains(path); });
    EXPECT_EQ(error.entry(), "outline 3");
    EXPECT_THAT(error.found(), HasSubstr("1000 times"));
}

TEST_F(OutlineGrains, refuseSettingsOfImages)
{
    const std::string path = saved("a.csv", "id,x,y\n1,0,0\n1,1,0\n1,0,1\n");
    ImageSettings light;
    light.lightGrains = true;
    ImageSettings labels;
    labels.labels = true;
    ImageSettings split;
    split.split = true;
    ImageSettings threshold;
    threshold.threshold = 3;
    EXPECT_EQ(test::errorOf<SetupError>([&] { readGrains(path, light); }).entry(), "light");
    EXPECT_EQ(test::errorOf<SetupError>([&] { readGrains(path, labels); }).entry(), "labels");
    EXPECT_EQ(test::errorOf<SetupError>([&] { readGrains(path, split); }).entry(), "split");
    EXPECT_EQ(test::errorOf<SetupError>([&] { readGrains(path, threshold); }).entry(), "threshold");
}
