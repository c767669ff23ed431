#include "core/world/namedMeasures.hpp"

#include "core/base/setupError.hpp"
#include "core/measure/polarHistogram.hpp"
#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

using namespace chesil;

namespace
{

World settled(int number, std::uint64_t seed)
{
    WorldSettings settings = test::mixedScene(number, seed);
    settings.walls.push_back({"lid", Vector2(0, 2), Vector2(0, -1)});
    World world(settings);
    world.updateForces();
    const double timeStep = world.stableTimeStep() / 2;
    for (int i = 0; i < 8000; ++i)
    {
        EXPECT_EQ(world.step(timeStep), StepStatus::done);
    }
    return world;
}

/// Value by column, without the unit.
std::map<std::string, double> valuesOf(const std::string& measure, const World& world)
{
    const NamedMeasure& named = measureNamed(measure);
    const std::vector<std::string> columns = named.columns(world);
    const std::vector<double> row = named.row(world);
    EXPECT_EQ(columns.size(), row.size()) << measure;
    std::map<std::string, double> values;
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
        const std::size_t blank = columns[i].find(" [");
        EXPECT_NE(blank, std::string::npos) << columns[i] << " has a unit";
        EXPECT_TRUE(values.emplace(columns[i].substr(0, blank), row[i]).second) << columns[i] << " stands twice";
    }
    return values;
}

} // namespace

TEST(NamedMeasures, eachHasANumberForEachColumn)
{
    const World world = settled(40, 81);
    std::set<std::string> names;
    for (const std::string& name : measureNames())
    {
        EXPECT_TRUE(names.insert(name).second) << name;
        for (const auto& [column, value] : valuesOf(name, world))
        {
            // Bins of a rose may be empty.
            EXPECT_TRUE(std::isfinite(value) || name == "roses") << name << ' ' << column;
        }
    }
    EXPECT_EQ(names.size(), 9u);
    EXPECT_THROW(measureNamed("temperature"), ValueError);
}

TEST(NamedMeasures, haveNothingToSayOfAnEmptyWorld)
{
    const World world(test::quartzSettings());
    for (const std::string& name : measureNames())
    {
        valuesOf(name, world);
    }
    EXPECT_TRUE(std::isnan(valuesOf("alignment", world)["order"]));
    EXPECT_TRUE(std::isnan(valuesOf("unbalanced", world)["largest"]));
    EXPECT_TRUE(std::isnan(valuesOf("stress", world)["xx"]));
}

TEST(NamedMeasures, rosesHoldTheDensityOfNormalsAndMeanForces)
{
    const World world = settled(80, 82);
    const std::vector<double> row = measureNamed("roses").row(world);
    ASSERT_EQ(row.size(), 108u);
    const double overHalfTurn = std::accumulate(row.begin(), row.begin() + 36, 0.0) * M_PI / 36;
    EXPECT_NEAR(overHalfTurn, 0.5, 1e-12) << "the other half turn has the other half";
    const auto values = valuesOf("roses", world);
    const std::vector<PolarBin> bins = polarHistogram(world.contacts(), 36, WallContacts::leftOut);
    for (std::size_t k = 0; k < 36; ++k)
    {
        const std::string angle = std::to_string(5 * k);
        EXPECT_EQ(values.at("density" + angle), bins[k].density);
        EXPECT_EQ(std::isnan(values.at("normalForce" + angle)), bins[k].contacts == 0);
        if (bins[k].contacts > 0)
        {
            EXPECT_EQ(values.at("normalForce" + angle), *bins[k].normalForce);
            EXPECT_EQ(values.at("tangentialForce" + angle), *bins[k].tangentialForce);
        }
    }
}

TEST(NamedMeasures, alignmentIsThatOfTheLongAxesInTheWorld)
{
    // An egg that is long along its x, one along its y, a disk: turned so that both eggs point the same way.
    WorldSettings settings = test::quartzSettings();
    settings.shapes = {{"lying", Ellipse(0.03, 0.02)}, {"standing", Ellipse(0.01, 0.04)}, {"disk", Circle(0.02)}};
    settings.grains.resize(3);
    for (int i = 0; i < 3; ++i)
    {
        settings.grains[static_cast<std::size_t>(i)].shape = i;
        settings.grains[static_cast<std::size_t>(i)].position = Vector2(i, 0);
    }
    settings.grains[0].angle = 0.4;
    settings.grains[1].angle = 0.4 + M_PI / 2;
    auto values = valuesOf("alignment", World(settings));
    EXPECT_NEAR(values["order"], 1, 1e-12);
    EXPECT_NEAR(values["director"], 0.4, 1e-12);
    EXPECT_EQ(values["grains"], 2) << "without the disk";
    // 0.4 rad lies in the bin about 25 degrees: all axes within 5 degrees of the half turn.
    EXPECT_NEAR(values["density25"], 36 / (2 * M_PI), 1e-12);
    EXPECT_EQ(values["density20"], 0);
    settings.grains[1].angle = 0.4;
    EXPECT_NEAR(valuesOf("alignment", World(settings))["order"], 0, 1e-12) << "crossed";
}

TEST(NamedMeasures, sharesOfNeighboursTellTheirMean)
{
    const World world = settled(40, 82);
    auto values = valuesOf("coordination", world);
    double sum = 0;
    double mean = 0;
    for (int neighbours = 0; neighbours <= 9; ++neighbours)
    {
        const double share = values["share" + std::to_string(neighbours)];
        sum += share;
        mean += neighbours * share;
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_GT(mean, 0);
    EXPECT_NEAR(mean, values["mean"], 1e-12);
}

TEST(NamedMeasures, aPackingThatSettlesGoesTowardsBalance)
{
    // A lone ball on the floor at its equilibrium depth is in balance; half as deep, half its weight is not borne.
    WorldSettings settings = test::freeBall();
    settings.gravity = Vector2(0, -9.81);
    settings.localDamping = 0.7;
    settings.walls = {test::floorWall()};
    const double depth = 2650 * M_PI * 0.05 * 0.05 * 9.81 / 1e6;
    for (const double share : {1.0, 0.5})
    {
        settings.grains[0].position = Vector2(0, 0.05 - share * depth);
        World world(settings);
        world.updateForces();
        EXPECT_NEAR(valuesOf("unbalanced", world)["largest"], (1 - share) / share, 1e-10);
    }
}
