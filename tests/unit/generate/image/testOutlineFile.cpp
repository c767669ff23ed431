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

std::string feature(const std::string& geometry, const std::string& members = R"("properties":{})")
{
    return R"({"type":"Feature",)" + members + R"(,"geometry":)" + geometry + "}";
}

std::string collection(const std::string& features)
{
    return R"({"type":"FeatureCollection","features":[)" + features + "]}";
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

TEST_F(OutlineFiles, geoJsonMembersMayStandInAnyOrder)
{
    // Type and geometry last, and what looks like features elsewhere.
    const std::string turned = R"({"geometry":{"coordinates":[)" + square +
                               R"(],"bbox":[[[[[0]]]]],"type":"Polygon"},"type":"Feature","id":4})";
    const OutlineFile file = readGeoJsonOutlines(
        saved("a.json", R"({"bbox":[0,[1]],"a":{"features":[{"b":[1,[2]]}]},"features":[)" + turned + "," +
                            turned + R"(],"c":[{"d":1}],"type":"FeatureCollection"})"));
    EXPECT_EQ(file.outlines.size(), 2u);
    EXPECT_EQ(file.names, (std::vector<std::string>{"4", "4"}));
    EXPECT_EQ(file.places, (std::vector<std::string>{"feature 1", "feature 2"}));
}

TEST_F(OutlineFiles, brokenJsonIsRefusedByLineOrFeature)
{
    const std::string good = feature(polygon(square));
    const std::string whole = collection(good + ",\n" + good);
    ASSERT_EQ(readGeoJsonOutlines(saved("whole.json", whole)).outlines.size(), 2u);
    for (std::size_t length = 1; length < whole.size(); ++length)
    {
        EXPECT_THAT(jsonRefusal(whole.substr(0, length)), testing::StartsWith("line ")) << length;
    }
    EXPECT_THAT(jsonRefusal(whole + "]"), AllOf(HasSubstr("line 2: "), HasSubstr("whole GeoJSON")));
    for (const std::string number : {"nan", "NaN", "Infinity", "-inf", "0x10", "1.", ".5", "01", "+1"})
    {
        EXPECT_THAT(jsonRefusal(polygon("[[0,0],[" + number + ",1],[0,1]]")), testing::StartsWith("line 1: "))
            << number;
    }
    EXPECT_THAT(jsonRefusal(collection(good + "," + feature(polygon("[[0,0],[-1e400,1],[0,1]]")))),
                AllOf(testing::StartsWith("feature 2: "), HasSubstr("'-1e400'")));
    for (const std::string value : {"null", "true", "[1]", "{}"})
    {
        EXPECT_THAT(jsonRefusal(collection(good + "," + feature(polygon("[[0,0],[1," + value + "],[0,1]]")))),
                    AllOf(testing::StartsWith("feature 2: "), HasSubstr("coordinate '" + value + "'")));
    }
    EXPECT_THAT(jsonRefusal(collection("7")), testing::StartsWith("feature 1: no geometry"));
    EXPECT_THAT(jsonRefusal(collection("[[" + good + "]]")), testing::StartsWith("feature 1: no geometry"));
    EXPECT_THAT(jsonRefusal(R"({"type":"FeatureCollection","features":{"a":)" + good + "}}"),
                HasSubstr("features that are no list"));
    EXPECT_THAT(jsonRefusal(R"({"type":"FeatureCollection","features":null})"), HasSubstr("no polygon"));
    EXPECT_THAT(jsonRefusal(R"({"features":[)" + good + "]}"), HasSubstr("no geometry"));
    EXPECT_THAT(jsonRefusal(R"({"type":"MultiPolygon","coordinates":[]})"), HasSubstr("without polygons"));
    EXPECT_THAT(jsonRefusal(R"({"type":"Polygon","coordinates":[[0,0],[1,0],[1,1]]})"),
                HasSubstr("position of 0"));
    EXPECT_THAT(jsonRefusal(R"({"type":"Polygon","coordinates":7})"), HasSubstr("without points"));
}

TEST_F(OutlineFiles, jsonMembersThatStandTwiceAreRefused)
{
    const std::string twice =
        R"({"type":"Polygon","coordinates":[)" + square + R"(],"coordinates":[)" + square + "]}";
    EXPECT_THAT(jsonRefusal(collection(feature(polygon(square)) + "," + feature(twice))),
                testing::StartsWith("feature 2: the member 'coordinates' twice; "));
    EXPECT_THAT(jsonRefusal(R"({"type":"Polygon","type":"Point","coordinates":[]})"),
                HasSubstr("'type' twice"));
    EXPECT_THAT(jsonRefusal(collection(feature(polygon(square), R"("id":1,"id":2)"))),
                HasSubstr("'id' twice"));
}

TEST_F(OutlineFiles, deepJsonIsRefusedWithoutUsingUpTheStack)
{
    for (const std::size_t depth : {std::size_t{200}, std::size_t{1000000}})
    {
        for (const std::string open : {"[", R"({"a":)"})
        {
            std::string lists;
            for (std::size_t i = 0; i < depth; ++i)
            {
                lists += open;
            }
            EXPECT_THAT(jsonRefusal(lists), HasSubstr("more than 100 within each other"));
            EXPECT_THAT(jsonRefusal(R"({"type":"Polygon","coordinates":)" + lists),
                        HasSubstr("more than 100"));
        }
    }
}

TEST_F(OutlineFiles, namesAreThoseOfTheFile)
{
    const std::string one = polygon(square);
    const std::string two = R"({"type":"MultiPolygon","coordinates":[[)" + square + "],[" + square + "]]}";
    const OutlineFile file = readGeoJsonOutlines(
        saved("a.json", collection(feature(one, R"("id":"a","properties":{"name":"b","id":"c"})") + "," +
                                   feature(one, R"("id":null,"properties":{"name":"b","id":"c"})") + "," +
                                   feature(one, R"("properties":{"other":1,"id":12})") + "," +
                                   feature(one, R"("properties":null)") + "," + feature(two, R"("id":2.5)") +
                                   "," + feature(two))));
    EXPECT_EQ(file.names, (std::vector<std::string>{"a", "b", "12", "", "2.5-1", "2.5-2", "", ""}));
    EXPECT_EQ(readGeoJsonOutlines(saved("b.json", feature(one, R"("id":"a")"))).names,
              (std::vector<std::string>{"a"}));
    EXPECT_THAT(jsonRefusal(collection(feature(one, R"("id":[1])"))),
                HasSubstr("feature 1: the name [1]; text or a number"));
    const OutlineFile csv =
        readCsvOutlines(saved("a.csv", "id,x,y\np7,0,0\np7,1,0\np7,0,1\n3,0,0\n3,1,0\n3,0,1\n"));
    EXPECT_EQ(csv.names, (std::vector<std::string>{"p7", "3"}));
    EXPECT_EQ(csv.places, (std::vector<std::string>{"line 2", "line 5"}));
}

TEST_F(OutlineGrains, haveTheNamesOfTheFile)
{
    const std::string one = polygon(square);
    const ImageGrains image =
        readGrains(saved("a.json", collection(feature(one, R"("id":"pebble")") + "," + feature(one))));
    EXPECT_EQ(image.name(0), "pebble");
    EXPECT_EQ(image.name(1), "grain2");
    EXPECT_EQ(readGrains(saved("b.json", one)).name(0), "grain1");

    const auto refusal = [&](const std::string& first, const std::string& second)
    {
        const std::string path =
            saved("c.json", collection(feature(one, first) + "," + feature(one, second)));
        return test::errorOf<SetupError>([&] { readGrains(path); });
    };
    const SetupError same = refusal(R"("id":"a")", R"("properties":{"name":"a"})");
    EXPECT_EQ(same.entry(), "feature 2");
    EXPECT_EQ(same.found(), "the name 'a', which feature 1 has, too");
    EXPECT_EQ(refusal(R"("id":"grain2")", R"("properties":{})").entry(), "feature 2");
    for (const std::string name : {"a b", "a#", "a,b", R"(\"a)", R"(a\n)", R"(a\u0000b)", R"(\u007f)", " "})
    {
        const SetupError error = refusal(R"("id":"a")", R"("id":")" + name + '"');
        EXPECT_EQ(error.entry(), "feature 2") << name;
        EXPECT_EQ(error.expected(), "a name without blanks and without # , \"") << name;
    }
    const std::string csv = saved("a.csv", "id,x,y\nfirst one,0,0\nfirst one,1,0\nfirst one,0,1\n");
    EXPECT_EQ(test::errorOf<SetupError>([&] { readGrains(csv); }).entry(), "line 2");
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
