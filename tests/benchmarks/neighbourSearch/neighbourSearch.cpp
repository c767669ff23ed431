/// Time of one neighbour search over the number of grains and their size ratio, and that of a search by
/// sorting.

#include "core/broadphase/neighbourSearch.hpp"
#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/neighbourSearch/scenes.hpp"
#include "benchmarks/neighbourSearch/sortedCells.hpp"
#include "unit/record.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr int rounds = 7;
/// Grains that one measurement searches at least, by repetition.
constexpr std::size_t leastGrains = 200000;

/// One curve: how to make the scene of a number of grains, which search, and up to which number.
struct Method
{
    std::string name;
    std::function<Scene(std::size_t)> scene;
    bool sorted = false;
    std::size_t most = 1000000;
};

Scene periodic(std::size_t number)
{
    Scene scene = twoSizes(number, 1);
    for (const Vector2& position : scene.positions)
    {
        scene.period = std::max(scene.period, position.maxCoeff() + 1);
    }
    return scene;
}

std::vector<Method> methods()
{
    const auto ratio = [](double sizeRatio)
    { return [=](std::size_t number) { return twoSizes(number, sizeRatio); }; };
    const auto random = [](double sizeRatio)
    { return [=](std::size_t number) { return allSizes(number, sizeRatio); }; };
    const auto mixed = [](std::size_t number) { return shuffled(twoSizes(number, 1)); };
    return {
        {"uniform", ratio(1)},
        {"uniform, random numbers", mixed},
        {"uniform, periodic", periodic},
        {"two sizes, 1:10", ratio(10)},
        {"two sizes, 1:100", ratio(100)},
        {"random, all one size", random(1)},
        {"random, sizes 1 to 10", random(10)},
        {"random, sizes 1 to 100", random(100)},
        {"layers of rods, 50:1", layers},
        {"sorting: uniform", ratio(1), true},
        {"sorting: uniform, random numbers", mixed, true},
        {"sorting: two sizes, 1:10", ratio(10), true, 200000},
        {"sorting: two sizes, 1:100", ratio(100), true, 20000},
    };
}

/// A scene with its search, warm.
struct Trial
{
    Scene scene;
    NeighbourSearch search;
    SortedCells sorting;

    std::size_t find(bool sorted)
    {
        if (sorted)
        {
            return sorting.find(scene.positions, scene.radii, sceneMargin).size();
        }
        if (scene.period > 0)
        {
            const PeriodicCell cell(Vector2(-1, -1), Vector2(scene.period, 0), Vector2(0, scene.period));
            return search.find(scene.positions, scene.halfExtents, scene.radii, sceneMargin, cell).size();
        }
        return search.find(scene.positions, scene.halfExtents, scene.radii, sceneMargin).size();
    }
};

/// What is known of one method at one number of grains.
struct Row
{
    double nanoseconds;
    double pairs;
};

using Rows = std::map<std::string, std::map<std::size_t, Row>>;

void measureAt(std::size_t number, Rows& rows, Results& results)
{
    std::vector<std::unique_ptr<Trial>> trials;
    std::vector<std::function<double()>> works;
    std::vector<Method> chosen;
    const std::size_t times = std::max<std::size_t>(1, leastGrains / number);
    for (const Method& method : methods())
    {
        if (number <= method.most)
        {
            chosen.push_back(method);
            trials.push_back(std::make_unique<Trial>());
            trials.back()->scene = method.scene(number);
            works.push_back(
                [trial = trials.back().get(), sorted = method.sorted, times]
                {
                    std::size_t pairs = 0;
                    for (std::size_t i = 0; i < times; ++i)
                    {
                        pairs = trial->find(sorted);
                    }
                    return static_cast<double>(pairs);
                });
        }
    }
    const std::vector<double> seconds = medianSeconds(works, rounds);
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
        const auto grains = static_cast<double>(number);
        const Row row{1e9 * seconds[i] / grains / static_cast<double>(times), works[i]() / grains};
        rows[chosen[i].name][number] = row;
        results.measurements.push_back({chosen[i].name, std::to_string(number), grains, row.nanoseconds});
        const double bytes = static_cast<double>(trials[i]->search.bytes()) / grains;
        std::printf("    %-34s %8zu  %6.1f  %6.2f  %6.1f  %5.0f\n", chosen[i].name.c_str(), number,
                    row.nanoseconds, row.pairs, row.nanoseconds / row.pairs, bytes);
    }
}

void summarize(const Rows& rows, Results& results)
{
    const auto add = [&results](const char* name, const std::string& line)
    {
        std::printf("    %s\n", line.c_str());
        results.comments.emplace_back(name, line);
    };
    for (const auto& [method, ofMethod] : rows)
    {
        std::vector<double> grains;
        std::vector<double> times;
        for (const auto& [number, row] : ofMethod)
        {
            grains.push_back(static_cast<double>(number));
            times.push_back(static_cast<double>(number) * row.nanoseconds);
        }
        add("order", text("time ~ grains^%.2f (%s)", logarithmicSlope(grains, times), method.c_str()));
    }
    double worst = 0;
    for (const auto& [number, uniform] : rows.at("uniform"))
    {
        const auto perPair = [](const Row& row) { return row.nanoseconds / row.pairs; };
        const Row& two = rows.at("two sizes, 1:100").at(number);
        const Row& all = rows.at("random, sizes 1 to 100").at(number);
        const Row& one = rows.at("random, all one size").at(number);
        worst = std::max(worst, perPair(two) / perPair(uniform));
        add("ratio",
            text("%zu grains, time a pair over that of like sizes: two sizes 1:100 %.2f, sizes 1 to 100 %.2f",
                 number, perPair(two) / perPair(uniform), perPair(all) / perPair(one)));
    }
    std::printf("    searchSizeRatio %.3f\n", worst);
    test::record("dryEngine", "searchSizeRatio", worst, "-");
}

/// The sizes and the sorting search in the first picture, all other scenes in one of their own.
Results inTwoPictures(Results all)
{
    const std::set<std::string> first{"uniform",
                                      "two sizes, 1:10",
                                      "two sizes, 1:100",
                                      "random, sizes 1 to 100",
                                      "sorting: uniform",
                                      "sorting: two sizes, 1:100"};
    Results others = all;
    others.suffix = "Scenes";
    others.comments.front().second = "Neighbour search, other scenes";
    const auto isFirst = [&](const auto& measurement) { return first.count(measurement.method) > 0; };
    const auto keepIf = [](Results& results, const auto& wanted)
    {
        auto& rows = results.measurements;
        rows.erase(std::remove_if(rows.begin(), rows.end(), [&](const auto& row) { return !wanted(row); }), rows.end());
    };
    keepIf(all, isFirst);
    keepIf(others, [&](const auto& row) { return !isFirst(row) || row.method == "uniform"; });
    all.beside = {others};
    return all;
}

Results measure()
{
    Results results;
    results.comments = {
        {"title", "Neighbour search over the number of grains"},
        {"error", "number of grains [-]"},
        {"time", "CPU time of one search [ns] a grain"},
        {"knob", "number of grains"},
        {"scenes", "solid fraction 0.8, margin 0.3 of the smallest radius, about 3 near pairs a grain"},
        {"median", text("of %d rounds", rounds)},
        {"seed", std::to_string(sceneSeed)},
    };
    std::printf("    %-34s   grains      ns   pairs ns/pair  bytes (each a grain)\n", "scene");
    Rows rows;
    for (const std::size_t number : {1000, 2000, 5000, 20000, 50000, 200000, 1000000})
    {
        measureAt(number, rows, results);
    }
    summarize(rows, results);
    return inTwoPictures(results);
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
