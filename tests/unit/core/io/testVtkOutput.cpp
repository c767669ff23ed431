#include "core/io/vtkOutput.hpp"

#include "core/base/setupError.hpp"
#include "unit/core/world/worldScenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

using namespace chesil;

namespace
{

std::string contentOf(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// An XML element: its attributes and the text in it; `children` in order.
struct Element
{
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;
    std::vector<Element> children;

    /// The first one of this name (and of this attribute Name) below, at any depth.
    const Element* find(const std::string& wanted, const std::string& called = "") const
    {
        for (const Element& child : children)
        {
            if (child.name == wanted &&
                (called.empty() || (child.attributes.count("Name") && child.attributes.at("Name") == called)))
            {
                return &child;
            }
            if (const Element* found = child.find(wanted, called))
            {
                return found;
            }
        }
        return nullptr;
    }

    std::vector<double> numbers() const
    {
        std::istringstream stream(text);
        std::vector<double> result;
        for (double number; stream >> number;)
        {
            result.push_back(number);
        }
        EXPECT_TRUE(stream.eof()) << "something that is no number in " << name;
        return result;
    }
};

/// As much of XML as VTK's files need: tags that match, attributes in quotes, no bare < in text.
Element parsed(const std::string& xml)
{
    const std::regex tag("<([?/]?)([A-Za-z]+)((\\s+[A-Za-z_]+=\"[^\"<]*\")*)\\s*([?/]?)>");
    std::vector<Element> open(1);
    auto position = xml.cbegin();
    for (std::smatch match; std::regex_search(position, xml.cend(), match, tag);
         position = match.suffix().first)
    {
        const std::string between(position, match[0].first);
        EXPECT_EQ(between.find_first_of("<>"), std::string::npos) << between;
        open.back().text += between;
        if (match[1] == "?")
        {
            continue;
        }
        if (match[1] == "/")
        {
            EXPECT_EQ(open.back().name, match[2]) << "tags that do not match";
            Element closed = open.back();
            open.pop_back();
            if (open.empty())
            {
                ADD_FAILURE() << "closed more than was opened";
                return {};
            }
            open.back().children.push_back(closed);
            continue;
        }
        Element element;
        element.name = match[2];
        const std::string attributes = match[3];
        const std::regex attribute("([A-Za-z_]+)=\"([^\"]*)\"");
        for (std::sregex_iterator i(attributes.begin(), attributes.end(), attribute), end; i != end; ++i)
        {
            element.attributes[(*i)[1]] = (*i)[2];
        }
        if (match[5] == "/")
        {
            open.back().children.push_back(element);
        }
        else
        {
            open.push_back(element);
        }
    }
    EXPECT_EQ(open.size(), 1u) << "never closed: " << open.back().name;
    EXPECT_EQ(std::string(position, xml.cend()), "\n");
    return open.front();
}

class VtkOutputTest : public testing::Test
{
protected:
    VtkOutputTest()
        : folder_(testing::TempDir() + "chesil_" + std::to_string(getpid()) + "_" +
                  testing::UnitTest::GetInstance()->current_test_info()->name())
    {
        std::filesystem::create_directories(folder_);
    }

    ~VtkOutputTest() override { std::filesystem::remove_all(folder_); }

    std::string folder_;
};

} // namespace

TEST_F(VtkOutputTest, oneClosedPolygonAGrainAlongItsOutline)
{
    const World world(test::mixedScene(30, 191));
    VtkOutput output(folder_, world);
    output.write(world, 0);
    const Element file = parsed(contentOf(folder_ + "/grains/grains_000000.vtp"));
    const Element* piece = file.find("Piece");
    ASSERT_NE(piece, nullptr);
    EXPECT_EQ(piece->attributes.at("NumberOfPolys"), "30");
    EXPECT_EQ(piece->attributes.at("NumberOfLines"), "0");

    const std::vector<double> points = file.find("Points")->find("DataArray")->numbers();
    const std::vector<double> connectivity = file.find("DataArray", "connectivity")->numbers();
    const std::vector<double> offsets = file.find("DataArray", "offsets")->numbers();
    ASSERT_EQ(offsets.size(), 30u);
    ASSERT_EQ(points.size(), 3 * connectivity.size());
    EXPECT_EQ(std::stoul(piece->attributes.at("NumberOfPoints")), connectivity.size());
    EXPECT_EQ(offsets.back(), static_cast<double>(connectivity.size()));

    std::size_t first = 0;
    for (std::size_t grain = 0; grain < 30; ++grain)
    {
        // The polygon's area is the grain's, less what the chords cut off: so it closes, and lies on the
        // outline.
        const auto last = static_cast<std::size_t>(offsets[grain]);
        std::vector<Vector2> polygon;
        for (std::size_t k = first; k < last; ++k)
        {
            const auto index = static_cast<std::size_t>(connectivity[k]);
            polygon.emplace_back(points[3 * index], points[3 * index + 1]);
            EXPECT_EQ(points[3 * index + 2], 0);
        }
        first = last;
        double area = 0;
        const Pose<2>& pose = world.bodies().pose[grain];
        for (std::size_t k = 0; k < polygon.size(); ++k)
        {
            const Vector2 next = polygon[(k + 1) % polygon.size()];
            area += cross(polygon[k] - pose.position, next - pose.position) / 2;
            // Each point is in the grain: in no direction further than the support point.
            const Vector2 outward = (polygon[k] - pose.position).normalized();
            const Vector2 furthest = support(world.shapeOf(grain), pose.rotation.applyInverse(outward));
            EXPECT_LE((polygon[k] - pose.position).dot(outward),
                      pose.rotation.apply(furthest).dot(outward) + 1e-8);
        }
        EXPECT_LE(area, world.areaOf(grain) * (1 + 1e-6)) << grain;
        EXPECT_GE(area, world.areaOf(grain) * (1 - 1e-3)) << grain;
    }
}

TEST_F(VtkOutputTest, everyGrainHasItsNumbers)
{
    const World world(test::mixedScene(12, 192));
    VtkOutput output(folder_, world);
    output.write(world, 0);
    const Element file = parsed(contentOf(folder_ + "/grains/grains_000000.vtp"));
    for (const char* name : {"id", "shape", "size", "angle", "speed", "angularVelocity"})
    {
        const Element* array = file.find("CellData")->find("DataArray", name);
        ASSERT_NE(array, nullptr) << name;
        EXPECT_EQ(array->numbers().size(), 12u) << name;
    }
    const std::vector<double> sizes = file.find("DataArray", "size")->numbers();
    for (std::size_t i = 0; i < 12; ++i)
    {
        EXPECT_NEAR(sizes[i], world.sizeOf(i), 1e-8 * sizes[i]);
    }
}

TEST_F(VtkOutputTest, theIndexListsAllStatesAndTheirFilesExist)
{
    World world(test::mixedScene(4, 193));
    VtkOutput output(folder_, world);
    for (const double time : {0.0, 0.5, 1.25})
    {
        output.write(world, time);
    }
    const Element index = parsed(contentOf(folder_ + "/grains.pvd"));
    const Element* collection = index.find("Collection");
    ASSERT_NE(collection, nullptr);
    ASSERT_EQ(collection->children.size(), 3u);
    EXPECT_EQ(std::stod(collection->children[2].attributes.at("timestep")), 1.25);
    for (const Element& state : collection->children)
    {
        EXPECT_TRUE(std::filesystem::exists(folder_ + "/" + state.attributes.at("file")));
    }
}

TEST_F(VtkOutputTest, wallsAreLinesAndNoGrainsAreNoPolygons)
{
    const World world(test::mixedScene(30, 194));
    VtkOutput output(folder_, world);
    const Element walls = parsed(contentOf(folder_ + "/grains/walls.vtp"));
    EXPECT_EQ(walls.find("Piece")->attributes.at("NumberOfLines"), "3");
    EXPECT_EQ(walls.find("Piece")->attributes.at("NumberOfPolys"), "0");
    // The floor reaches from the left wall to the right one.
    const std::vector<double> points = walls.find("Points")->find("DataArray")->numbers();
    EXPECT_NEAR(std::abs(points[3] - points[0]), 0.6, 1e-9);

    const World empty(test::quartzSettings());
    VtkOutput nothing(folder_, empty);
    nothing.write(empty, 0);
    EXPECT_EQ(parsed(contentOf(folder_ + "/grains/grains_000000.vtp"))
                  .find("Piece")
                  ->attributes.at("NumberOfPolys"),
              "0");
}

TEST_F(VtkOutputTest, aPeriodicCellIsAClosedLineThatGoesWithTheStrain)
{
    WorldSettings settings = test::freeBall();
    settings.grains[0].position = Vector2(0.3, 0.3);
    Eigen::Matrix2d shear = Eigen::Matrix2d::Zero();
    shear(0, 1) = 0.5;
    settings.cell.emplace(PeriodicCell(Vector2(0.1, 0), Vector2(0.6, 0), Vector2(0, 0.4)), shear);
    World world(settings);
    world.updateForces();
    VtkOutput output(folder_, world);
    const auto points = [&] { return parsed(contentOf(folder_ + "/grains/walls.vtp")).find("Points")->find("DataArray")->numbers(); };
    EXPECT_EQ(points(), (std::vector<double>{0.1, 0, 0, 0.7, 0, 0, 0.7, 0.4, 0, 0.1, 0.4, 0, 0.1, 0, 0}));
    for (int i = 0; i < 100; ++i)
    {
        ASSERT_EQ(world.step(1e-3), StepStatus::done);
    }
    output.write(world, 0.1);
    // Sheared by 0.05: the upper side has gone 0.02 m to the right.
    EXPECT_NEAR(points()[6], 0.72, 1e-8);
    EXPECT_NEAR(points()[9], 0.12, 1e-8);
}

TEST_F(VtkOutputTest, anEarlierRunsFilesAreGone)
{
    const World world(test::mixedScene(3, 195));
    {
        VtkOutput longer(folder_, world);
        longer.write(world, 0);
        longer.write(world, 1);
    }
    VtkOutput shorter(folder_, world);
    shorter.write(world, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ + "/grains/grains_000001.vtp"));
}

TEST_F(VtkOutputTest, aFolderThatCannotBeMadeIsNamed)
{
    const World world(test::mixedScene(3, 196));
    std::ofstream(folder_ + "/file") << "in the way";
    EXPECT_THROW(VtkOutput(folder_ + "/file", world), SetupError);
}
