#include "core/io/templateFile.hpp"

#include "core/base/setupError.hpp"
#include "unit/randomGrain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

using namespace chesil;
using testing::HasSubstr;

namespace
{

std::string scratchFile()
{
    return testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".chesil";
}

std::string contentOf(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// Reads a file of this content, which must be refused, and gives the error.
SetupError refusal(const std::string& content)
{
    const std::string path = scratchFile();
    std::ofstream(path) << content;
    try
    {
        readTemplates(path);
    }
    catch (const SetupError& error)
    {
        EXPECT_EQ(error.file(), path);
        std::remove(path.c_str());
        return error;
    }
    ADD_FAILURE() << "not refused:\n" << content;
    return SetupError("", "", "", "");
}

std::string withGrain(const std::string& grain)
{
    return "chesilTemplates 1\nunit m\ncount 1\n" + grain + "end\n";
}

const std::string square = "grain tile polygon 4\n0 0\n1 0\n1 1\n0 1\n";

TemplateFile oneOfEach()
{
    test::RandomSource random(5);
    TemplateFile templates;
    templates.unit = "pixel";
    templates.grains.push_back({"ball", Circle(0.1)});
    templates.grains.push_back({"egg", Ellipse(1.0 / 3, 2e-7)});
    templates.grains.push_back({"tile", test::randomPolygon(7, 1e-3, random)});
    for (int i = 0; i < 50; ++i)
    {
        test::RandomGrainOptions options;
        options.radius = random.logUniform(1e-6, 1e3);
        options.straight = i % 3;
        templates.grains.push_back({"pebble" + std::to_string(i), test::randomPolyBezier(options, random)});
    }
    return templates;
}

} // namespace

TEST(TemplateFile, isReadBackToTheBit)
{
    const std::string path = scratchFile();
    const TemplateFile written = oneOfEach();
    writeTemplates(path, written);
    const TemplateFile read = readTemplates(path);
    EXPECT_EQ(read.unit, "pixel");
    ASSERT_EQ(read.grains.size(), written.grains.size());
    for (std::size_t i = 0; i < read.grains.size(); ++i)
    {
        EXPECT_EQ(read.grains[i].name, written.grains[i].name);
        ASSERT_EQ(read.grains[i].shape.index(), written.grains[i].shape.index());
        EXPECT_EQ(massProperties(read.grains[i].shape).polarMoment,
                  massProperties(written.grains[i].shape).polarMoment);
        if (const auto* grain = std::get_if<PolyBezier>(&read.grains[i].shape))
        {
            const auto& before = std::get<PolyBezier>(written.grains[i].shape).segments();
            ASSERT_EQ(grain->segments().size(), before.size());
            for (std::size_t k = 0; k < before.size(); ++k)
            {
                EXPECT_EQ(grain->segments()[k].controlPoints(), before[k].controlPoints());
            }
        }
    }
    EXPECT_EQ(std::get<ConvexPolygon>(read.grains[2].shape).vertices(),
              std::get<ConvexPolygon>(written.grains[2].shape).vertices());

    const std::string firstContent = contentOf(path);
    writeTemplates(path, read);
    EXPECT_EQ(contentOf(path), firstContent);
    std::remove(path.c_str());
}

TEST(TemplateFile, passesOverCommentsAndEmptyLines)
{
    const std::string path = scratchFile();
    std::ofstream(path) << "# pebbles\nchesilTemplates 1\n\nunit m # metres\ncount 1\n  grain ball circle "
                           "0.01 # radius\nend\n\n";
    const TemplateFile read = readTemplates(path);
    ASSERT_EQ(read.grains.size(), 1u);
    EXPECT_EQ(std::get<Circle>(read.grains[0].shape).radius(), 0.01);
    std::remove(path.c_str());
}

TEST(TemplateFile, missingFileAndFolderAreNamed)
{
    for (const std::string& path : {testing::TempDir() + "noSuchFile.chesil", testing::TempDir()})
    {
        EXPECT_THROW(readTemplates(path), SetupError) << path;
    }
}

TEST(TemplateFile, everyCutIsNoticed)
{
    const std::string path = scratchFile();
    TemplateFile templates = oneOfEach();
    templates.grains.erase(templates.grains.begin() + 5, templates.grains.end());
    writeTemplates(path, templates);
    const std::string whole = contentOf(path);
    // Without its last line break the file is still whole.
    for (std::size_t length = 0; length + 1 < whole.size(); ++length)
    {
        std::ofstream(path) << whole.substr(0, length);
        EXPECT_THROW(readTemplates(path), SetupError) << "cut after " << length << " characters";
    }
    std::remove(path.c_str());
}

TEST(TemplateFile, cutFileIsNamedWithItsLine)
{
    const SetupError error = refusal("chesilTemplates 1\nunit m\ncount 2\n" + square);
    EXPECT_EQ(error.entry(), "line 9");
    EXPECT_THAT(error.found(), HasSubstr("end of the file"));
}

TEST(TemplateFile, moreOrFewerGrainsThanCountedAreRefused)
{
    EXPECT_EQ(refusal("chesilTemplates 1\nunit m\ncount 0\n" + square + "end\n").entry(), "line 4");
    EXPECT_THAT(refusal("chesilTemplates 1\nunit m\ncount 2\n" + square + "end\n").found(), HasSubstr("end"));
    EXPECT_THAT(refusal(withGrain(square) + square).expected(), HasSubstr("nothing after 'end'"));
}

TEST(TemplateFile, wrongHeaderIsRefused)
{
    EXPECT_EQ(refusal("").entry(), "line 1");
    EXPECT_EQ(refusal("chesilTemplates 2\nunit m\ncount 0\nend\n").entry(), "line 1");
    EXPECT_EQ(refusal("\x89PNG\r\n\x1a\n").entry(), "line 1");
    const SetupError unit = refusal("chesilTemplates 1\nunit mm\ncount 0\nend\n");
    EXPECT_EQ(unit.entry(), "line 2");
    EXPECT_THAT(unit.found(), HasSubstr("mm"));
    EXPECT_THAT(unit.expected(), HasSubstr("m, pixel"));
    for (const char* count : {"-1", "1.5", "many", "nan", "1e99"})
    {
        EXPECT_EQ(refusal("chesilTemplates 1\nunit m\ncount " + std::string(count) + "\nend\n").entry(),
                  "line 3")
            << count;
    }
}

TEST(TemplateFile, unknownTypeListsTheKnownOnes)
{
    const SetupError error = refusal(withGrain("grain ball sphere 1\n"));
    EXPECT_EQ(error.entry(), "line 4");
    EXPECT_THAT(error.found(), HasSubstr("sphere"));
    EXPECT_THAT(error.expected(), HasSubstr("circle, ellipse, polygon, polybezier"));
}

TEST(TemplateFile, badNumbersAreNamedWithTheirLine)
{
    for (const char* number : {"nan", "inf", "1e999", "one", "1,5", "0x"})
    {
        const SetupError error =
            refusal(withGrain("grain tile polygon 4\n0 0\n1 " + std::string(number) + "\n1 1\n0 1\n"));
        EXPECT_EQ(error.entry(), "line 6") << number;
        EXPECT_THAT(error.found(), HasSubstr(number));
    }
    EXPECT_EQ(refusal(withGrain("grain tile polygon 4\n0 0\n1 0 7\n1 1\n0 1\n")).entry(), "line 6");
    EXPECT_EQ(refusal(withGrain("grain ball circle\n")).entry(), "line 4");
    EXPECT_EQ(refusal(withGrain("grain ball circle -1\n")).entry(), "line 4");
    EXPECT_EQ(refusal(withGrain("grain egg ellipse 1 0\n")).entry(), "line 4");
    EXPECT_EQ(refusal(withGrain("grain tile polygon 0\n")).entry(), "line 4");
}

TEST(TemplateFile, shapesThatAreNotConvexAreNamedWithTheirGrain)
{
    const std::string dented = "grain dented polygon 5\n0 0\n2 0\n1 0.5\n2 2\n0 2\n";
    const std::string star = "grain star polygon 5\n1 0\n-0.81 0.59\n0.31 -0.95\n0.31 0.95\n-0.81 -0.59\n";
    const std::string clockwise = "grain clockwise polygon 3\n0 0\n0 1\n1 0\n";
    const std::string wavy = "grain wavy polybezier 2\n0 0 1 -1 2 1\n3 0 2 2 1 2\n";
    for (const std::string& grain : {dented, star, clockwise, wavy})
    {
        const SetupError error = refusal(withGrain(grain));
        EXPECT_EQ(error.entry(), "line 4");
        EXPECT_THAT(error.found(), HasSubstr(grain.substr(6, grain.find(' ', 6) - 6)));
        EXPECT_THAT(error.expected(), HasSubstr("convex"));
    }
}

TEST(TemplateFile, aNameStandsForOneGrain)
{
    const SetupError error = refusal("chesilTemplates 1\nunit m\ncount 2\n" + square + square + "end\n");
    EXPECT_THAT(error.found(), HasSubstr("tile"));
    const NamedShape ball{"ball", Circle(1)};
    EXPECT_THROW(writeTemplates(scratchFile(), {"m", {ball, ball}}), SetupError);
    for (const char* name : {"", "two words", "a#b"})
    {
        EXPECT_THROW(writeTemplates(scratchFile(), {"m", {{name, Circle(1)}}}), SetupError) << name;
    }
    EXPECT_THROW(writeTemplates(scratchFile(), {"feet", {ball}}), SetupError);
}

TEST(TemplateFile, isNotTouchedByAFailedWrite)
{
    const std::string path = scratchFile();
    writeTemplates(path, {"m", {{"ball", Circle(1)}}});
    const std::string before = contentOf(path);
    EXPECT_THROW(writeTemplates(path, {"feet", {}}), SetupError);
    EXPECT_EQ(contentOf(path), before);
    std::remove(path.c_str());
    EXPECT_THROW(writeTemplates(testing::TempDir() + "noSuchFolder/x.chesil", {"m", {}}), SetupError);
}
