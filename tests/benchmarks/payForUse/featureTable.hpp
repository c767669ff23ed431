#pragma once

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/payForUse/diskScenes.hpp"
#include "core/world/namedMeasures.hpp"

#include <functional>
#include <memory>

/// The time of a step with each feature off and on.
namespace chesil::benchmark
{

/// One line of the table: a scene with one feature on, and what is asked of the world after each thousand steps.
struct Feature
{
    std::string name;
    WorldSettings settings;
    std::function<double(const World&)> ask = [](const World&) { return 0.0; };
};

constexpr int stepsOfTable = 1000;
constexpr int roundsOfTable = 9;

/// A Hertzian contact about as stiff as the linear one at the bed's overlaps [Pa].
constexpr double modulusOfTable = 2e9;

inline WorldSettings threeMaterials(WorldSettings settings)
{
    const LinearLaw law = settings.linear();
    LawTable<LinearLaw> laws(3);
    for (std::size_t a = 0; a < 3; ++a)
    {
        for (std::size_t b = a; b < 3; ++b)
        {
            laws.set(a, b, law);
        }
    }
    settings.contact = laws;
    settings.materials = std::vector<Material>(3, settings.materials[0]);
    for (std::size_t i = 0; i < settings.grains.size(); ++i)
    {
        settings.grains[i].material = static_cast<int>(i % 3);
    }
    return settings;
}

inline WorldSettings hertzian(WorldSettings settings, double friction)
{
    LawTable<HertzMindlinLaw> laws;
    laws.only().effectiveModulus = modulusOfTable;
    laws.only().effectiveShearModulus = modulusOfTable / 4;
    laws.only().friction = friction;
    laws.only().dampingRatio = settings.linear().dampingRatio;
    settings.contact = laws;
    return settings;
}

/// Without the walls at the sides, which the strip's images stand for.
inline WorldSettings periodic(WorldSettings settings)
{
    const double side = settings.walls[2].point.x();
    settings.cell.emplace(PeriodicCell(Vector2::Zero(), Vector2(side, 0), Vector2::Zero()));
    settings.walls = {settings.walls[0], settings.walls[3]};
    return settings;
}

inline double allMeasures(const World& world)
{
    double sum = 0;
    for (const NamedMeasure& measure : namedMeasures())
    {
        sum += measure.row(world).front();
    }
    return sum;
}

/// Each differs from the first, `plain`, by one feature; those that need friction have it, too, and say so.
inline std::vector<Feature> featuresOf(const WorldSettings& plain)
{
    std::vector<Feature> features;
    const auto add = [&](const std::string& name, const WorldSettings& start, const std::function<void(WorldSettings&)>& change)
    {
        features.push_back({name, start});
        change(features.back().settings);
    };
    WorldSettings rough = plain;
    rough.linear().friction = sceneFriction;
    add("baseline: all off", plain, [](WorldSettings&) {});
    add("friction", rough, [](WorldSettings&) {});
    add("friction and rolling resistance", rough, [](WorldSettings& s) { s.linear().rollingFriction = 0.1; });
    add("local damping", plain, [](WorldSettings& s) { s.localDamping = 0.3; });
    add("viscous damping", plain, [](WorldSettings& s) { s.viscousDamping = 1; });
    add("cohesion", plain, [](WorldSettings& s) { s.linear().cohesion = 1; });
    add("energy ledger", plain, [](WorldSettings& s) { s.energyLedger = true; });
    add("contact statistics", plain, [](WorldSettings& s) { s.contactStatistics = true; });
    add("three materials", threeMaterials(plain), [](WorldSettings&) {});
    add("Hertz", hertzian(plain, 0), [](WorldSettings&) {});
    add("Hertz-Mindlin with friction", hertzian(plain, sceneFriction), [](WorldSettings&) {});
    add("moving floor", plain,
        [](WorldSettings& s) { s.walls[0].motion = DrivenWall{Vector2::Zero(), Vector2(0, 1e-7), 10}; });
    add("periodic cell", periodic(plain), [](WorldSettings&) {});
    features.push_back({"all measures each 1000 steps", plain, allMeasures});
    features.push_back({"state() each 1000 steps", plain, [](const World& world) { return world.state().time; }});
    return features;
}

/// Of the contact list [bytes a grain]: entries, and the springs of friction.
inline std::string memoryOf(const World& world)
{
    const double grains = static_cast<double>(world.bodies().size());
    return text("entries %.1f, springs %.1f bytes a grain", world.contacts().size() * sizeof(Contact<2>) / grains,
                world.springs().size() * sizeof(double) / grains);
}

/// All worlds run in turn, from the settled bed `plain`.
inline Results measureTable(const WorldSettings& plain)
{
    const std::vector<Feature> features = featuresOf(plain);
    const double timeStep = World(plain).stableTimeStep() / 2;
    std::vector<std::unique_ptr<World>> worlds;
    std::vector<std::function<double()>> works;
    for (const Feature& feature : features)
    {
        worlds.push_back(std::make_unique<World>(feature.settings));
        works.push_back(
            [world = worlds.back().get(), timeStep, &feature]
            {
                runSteps(*world, timeStep, stepsOfTable);
                return feature.ask(*world);
            });
    }
    const std::vector<double> seconds = medianSeconds(works, roundsOfTable);

    Results results;
    results.suffix = "Features";
    results.comments = {
        {"title", "Time of a step with each feature on, settled disks"},
        {"error", "time over that of the baseline, less 1 [-]"},
        {"time", "CPU time [ns] a grain and step"},
        {"knob", "number of grains"},
        {"drawing", "bars"},
        {"memory", "friction off: " + memoryOf(*worlds[0])},
        {"memory", "friction on: " + memoryOf(*worlds[1])},
    };
    for (std::size_t i = 0; i < features.size(); ++i)
    {
        const double ratio = seconds[i] / seconds[0];
        const double nanoseconds = 1e9 * seconds[i] / stepsOfTable / static_cast<double>(plain.grains.size());
        results.measurements.push_back({features[i].name, std::to_string(features[0].settings.grains.size()), ratio - 1, nanoseconds});
        std::printf("    %-34s %6.3f  %8.1f\n", features[i].name.c_str(), ratio, nanoseconds);
    }
    std::printf("    friction off: %s\n    friction on:  %s\n", memoryOf(*worlds[0]).c_str(), memoryOf(*worlds[1]).c_str());
    return results;
}

} // namespace chesil::benchmark
