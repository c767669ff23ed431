/// Cost of a step of our engine over the number of grains: the scenes of dryThroughput from 10^3 to 10^6
/// grains.

#include "benchmarks/dryThroughput/packing.hpp"
#include "unit/record.hpp"

#include <array>
#include <map>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

/// Of the cell that is repeated, and its repeats along both vectors.
constexpr int cellGrains = 1000;
constexpr std::array<std::array<int, 2>, 4> repeats = {{{1, 1}, {5, 2}, {10, 10}, {40, 25}}};
constexpr int rounds = 7;
/// Of all grains together in one round, whatever their number.
constexpr int grainSteps = 4000000;

/// Chains of packings that grow.
struct Method
{
    const char* name;
    Grains kind;
    double solidFraction;
    Numbering numbering;
};

constexpr std::array<Method, 3> methods = {
    {{"disks, numbered at random", Grains::disks, diskFraction, Numbering::random},
     {"disks, numbered by place", Grains::disks, diskFraction, Numbering::byPlace},
     {"polybeziers, numbered at random", Grains::polyBeziers, polyBezierFraction, Numbering::random}}};

/// Steps all numbers of grains in turn.
void measureMethod(const Method& method, Results& results, std::map<std::string, double>& slopes)
{
    const Scene cell = flowingCell(method.kind, cellGrains, method.solidFraction);
    std::vector<std::unique_ptr<World>> worlds;
    std::vector<std::function<double()>> works;
    for (const auto& [along, up] : repeats)
    {
        worlds.push_back(std::make_unique<World>(settingsOf(tiled(cell, along, up, method.numbering))));
        works.push_back(
            [world = worlds.back().get()]
            {
                runSteps(*world, sceneTimeStep, grainSteps / static_cast<int>(world->bodies().size()));
                return world->bodies().pose.front().position.x();
            });
    }
    const std::vector<double> seconds = medianSeconds(works, rounds);
    std::vector<double> numbers;
    for (std::size_t i = 0; i < worlds.size(); ++i)
    {
        numbers.push_back(static_cast<double>(worlds[i]->bodies().size()));
        const double nanoseconds = 1e9 * seconds[i] / grainSteps;
        results.measurements.push_back({method.name, text("%.0f", numbers[i]), numbers[i], nanoseconds});
        std::printf("    %-34s %8.0f  %7.1f ns, %.2f contacts a grain\n", method.name, numbers[i],
                    nanoseconds, contactsAGrain(*worlds[i]));
    }
    const double slope = 1 + logarithmicSlope(numbers, seconds);
    slopes[method.name] = slope;
    results.comments.emplace_back("order", text("time ~ grains^%.3f (%s)", slope, method.name));
    std::printf("    %s\n", results.comments.back().second.c_str());
}

Results measure()
{
    Results results;
    results.comments = {{"title", "Cost of a step over the number of grains"},
                        {"error", "number of grains [-]"},
                        {"time", "CPU time of one step [ns] a grain"},
                        {"knob", "number of grains"},
                        {"scenes", "dense packings in simple shear, periodic"},
                        {"median", text("of %d rounds", rounds)},
                        {"seed", std::to_string(templateSeed)}};
    std::map<std::string, double> slopes;
    for (const Method& method : methods)
    {
        measureMethod(method, results, slopes);
    }
    test::record("dryEngine", "costSlopeDeviation", std::abs(slopes.at("disks, numbered by place") - 1), "-");
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
