/// What features cost a scene that does not use them, and what they cost one that does. Run by Allrun, which
/// adds the comparison with a build that knows disks only; for that this program also serves steps ("-steps
/// <scene>").

#include "benchmarks/payForUse/featureTable.hpp"
#include "benchmarks/payForUse/stepServer.hpp"
#include "core/world/pairContact.hpp"
#include "unit/record.hpp"

#include <cstring>
#include <memory>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr int stepsToSettle = 16000;
constexpr int stepsAtATime = 40;
constexpr int rounds = 60;

/// Asks once more for the contact of every near pair of grains, counted if a cost is handed over.
template <class Look, class... Cost>
void askAll(const World& world, const Look& look, Cost&... cost)
{
    const std::vector<Pose<2>>& pose = world.bodies().pose;
    for (const Contact<2>& contact : world.contacts())
    {
        if (contact.withWall() || contact.place == 1)
        {
            continue;
        }
        const auto i = static_cast<std::size_t>(contact.first);
        const auto j = static_cast<std::size_t>(contact.second);
        SearchStart start{contact.normal, contact.turn};
        ContactGeometry<2> geometry;
        geometry.depth = 0;
        pairContact(world.shapeOf(i), pose[i], world.shapeOf(j), pose[j], start, geometry, cost...);
        look(geometry);
    }
}

/// Support calls of A - B if all near pairs of the world are looked at once more.
long supportCallsOf(const World& world, long& pairs)
{
    QueryCost cost;
    askAll(world, [&](const ContactGeometry<2>&) { ++pairs; }, cost);
    return cost.supportCalls;
}

/// Over many moments of a bed that falls and settles, and of a gas.
void countSearches(Results& results)
{
    long pairs = 0;
    long calls = 0;
    for (const WorldSettings& settings : {bedOf(diskShapes(), ratioGrains), gasOf(diskShapes(), ratioGrains)})
    {
        World world(settings);
        const double timeStep = world.stableTimeStep();
        for (int moment = 0; moment < 100; ++moment)
        {
            runSteps(world, timeStep, stepsToSettle / 100);
            calls += supportCallsOf(world, pairs);
        }
    }
    const std::string line = text("%ld in %ld queries of disk pairs", calls, pairs);
    std::printf("    support calls: %s\n", line.c_str());
    results.comments.emplace_back("supportCalls", line);
    test::record("contactKernel", "diskWorldSearches", static_cast<double>(calls), "-");
}

/// The bed, settled.
WorldSettings settledBed(std::vector<NamedShape> shapes, int grains)
{
    WorldSettings settings = bedOf(std::move(shapes), grains);
    World world(settings);
    runSteps(world, world.stableTimeStep(), stepsToSettle);
    for (std::size_t i = 0; i < settings.grains.size(); ++i)
    {
        const Rotation<2>& rotation = world.bodies().pose[i].rotation;
        const Vector2 turned = rotation.apply(Vector2::UnitX());
        settings.grains[i].position = world.bodies().pose[i].position;
        settings.grains[i].angle = std::atan2(turned.y(), turned.x());
    }
    return settings;
}

/// One line of the table: a scene under a name.
struct Variant
{
    std::string name;
    WorldSettings settings;
};

/// Largest distance of a grain in one world from the same grain in the other, over the mean radius.
double difference(const World& one, const World& other)
{
    double largest = 0;
    for (std::size_t i = 0; i < one.bodies().size(); ++i)
    {
        largest = std::max(largest, (one.bodies().pose[i].position - other.bodies().pose[i].position).norm());
    }
    return largest / ((smallestRadius + largestRadius) / 2);
}

void addRow(const std::string& name, int grains, double error, double nanoseconds, Results& results)
{
    results.measurements.push_back({name, std::to_string(grains), error, nanoseconds});
    std::printf("    %-34s %5d  %8.1e  %8.1f\n", name.c_str(), grains, error, nanoseconds);
}

/// Steps all worlds in turn; the first is what the others are compared with.
void measureSteps(const std::vector<Variant>& variants, Results& results)
{
    std::vector<std::unique_ptr<World>> worlds;
    std::vector<std::function<double()>> works;
    const double timeStep = World(variants.front().settings).stableTimeStep() / 2;
    for (const Variant& variant : variants)
    {
        worlds.push_back(std::make_unique<World>(variant.settings));
        works.push_back(
            [world = worlds.back().get(), timeStep]
            {
                runSteps(*world, timeStep, stepsAtATime);
                return world->bodies().pose.front().position.x();
            });
    }
    const std::vector<double> seconds = medianSeconds(works, rounds);
    for (std::size_t i = 0; i < variants.size(); ++i)
    {
        const int grains = static_cast<int>(variants[i].settings.grains.size());
        const bool sameShapes = variants[i].settings.shapes.front().shape.index() == Shape(Circle(1)).index();
        addRow(variants[i].name, grains, sameShapes ? difference(*worlds[i], *worlds[0]) : 0,
               1e9 * seconds[i] / stepsAtATime / grains, results);
    }
}

/// Depths of all near pairs of a settled bed, counted or not.
template <class... Cost>
double depthsOf(const World& world, Cost&... cost)
{
    double sum = 0;
    askAll(world, [&](const ContactGeometry<2>& geometry) { sum += geometry.depth; }, cost...);
    return sum;
}

void measureCounting(const std::string& scene, const WorldSettings& settings, Results& results)
{
    World world(settings);
    world.updateForces();
    QueryCost cost;
    constexpr int times = 100;
    const auto repeated = [](auto depths)
    {
        double sum = 0;
        for (int i = 0; i < times; ++i)
        {
            sum += depths();
        }
        return sum;
    };
    const auto uncounted = [&] { return depthsOf(world); };
    const auto counted = [&] { return depthsOf(world, cost); };
    const std::vector<double> seconds =
        medianSeconds({[&] { return repeated(uncounted); }, [&] { return repeated(counted); }}, rounds);
    const int grains = static_cast<int>(settings.grains.size());
    addRow(scene + ", queries not counted", grains, 0, 1e9 * seconds[0] / times / grains, results);
    addRow(scene + ", queries counted", grains, std::abs(counted() / uncounted() - 1),
           1e9 * seconds[1] / times / grains, results);
}

Shape hexagon(double radius)
{
    std::vector<Vector2> vertices;
    for (int i = 0; i < 6; ++i)
    {
        vertices.push_back(radius * Vector2(std::cos(i * M_PI / 3), std::sin(i * M_PI / 3)));
    }
    return ConvexPolygon(vertices);
}

void measureFeatures(int grains, Results& results)
{
    const WorldSettings disks = settledBed(diskShapes(), grains);
    const WorldSettings hexagons = settledBed(shapesOfRadii(hexagon), grains);
    WorldSettings smooth = disks;
    smooth.linear().friction = 0;
    WorldSettings damped = disks;
    damped.localDamping = 0.7;
    measureSteps({{"disks", disks},
                  {"disks, friction off", smooth},
                  {"disks, local damping on", damped},
                  {"hexagons", hexagons}},
                 results);
    measureCounting("disks", disks, results);
    measureCounting("hexagons", hexagons, results);
}

Results measure()
{
    Results results;
    results.comments = {
        {"title", "Cost of features in settled beds"},
        {"error", "distance from the first row's state [mean radii]"},
        {"time", "CPU time [ns] a grain and step"},
        {"knob", "number of grains"},
        {"drawing", "bars"},
        {"seed", std::to_string(sceneSeed)},
    };
    countSearches(results);
    std::printf("    scene                             grains     error        ns\n");
    for (const int grains : {500, 2000})
    {
        measureFeatures(grains, results);
    }
    WorldSettings plain = settledBed(diskShapes(), 2000);
    plain.linear().friction = 0;
    results.beside.push_back(measureTable(plain));
    return results;
}

} // namespace

int main(int argumentCount, char** arguments)
{
    if (argumentCount == 3 && std::strcmp(arguments[1], "-steps") == 0)
    {
        return mainOfServer(argumentCount, arguments);
    }
    return run(argumentCount, arguments, measure);
}
