/// What softer grains save and what it costs: the solid fraction of a heap against that of the same heap of
/// hard grains, over the run time. Poured at each stiffness anew, heaps would differ by chance instead
/// (comment "scatter" of the table).
///
/// A heap is poured without friction, so that no friction spring is under load, and hardened step by step.
/// Then friction holds it together, and each stiffness begins from there: the soft grains sink into each
/// other and hardly any finds a new neighbour.

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/common/irregularGrains.hpp"
#include "unit/record.hpp"

#include <algorithm>
#include <iterator>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr std::uint64_t seeds[] = {21, 22, 23};
constexpr int grains = 200;
/// Of the box before the grains fall.
constexpr double looseFraction = 0.4;
constexpr double gravity = 9.81;
constexpr double friction = 0.5;
/// Tangential over normal stiffness, 4 G/E of Hertz's force.
constexpr double tangentialShare = 0.8;
/// Stiffness levels: stiffness [N/m] over the pressure on the floor times 1 m, about 1 over the relative
/// overlap (da Cruz et al. 2005). The hardest stands for hard grains.
constexpr double pouredLevel = 1e3;
constexpr double levels[] = {1e2, 3e2, 1e3, 3e3, 1e4, 3e4, 1e5};
constexpr double hardestLevel = 1e7;
/// Falling; coming to rest [s].
constexpr double pouring = 1.2;
constexpr double resting = 0.15;

struct Heap
{
    WorldSettings settings;
    /// Weight of the grains over the width of the floor [N/m], and so the stiffness of level 1.
    double pressure = 0;
    double hardFraction = 0;
};

struct Rest
{
    std::vector<GrainState> grains;
    double solidFraction = 0;
    /// Kinetic energy left over what a fall of all grains by their mean radius gives.
    double kinetic = 0;
    double overlap = 0;
    double seconds = 0;
};

using LawOf = ContactLaws (*)(double stiffness, double coefficient);

ContactLaws linearLaw(double stiffness, double coefficient)
{
    LawTable<LinearLaw> table;
    table.only().normalStiffness = stiffness;
    table.only().tangentialStiffness = tangentialShare * stiffness;
    table.only().friction = coefficient;
    table.only().dampingRatio = 0.05;
    return table;
}

/// As stiff as that at the largest overlap that its stable step allows for, and so with steps as long.
ContactLaws hertzLaw(double stiffness, double coefficient)
{
    LawTable<HertzMindlinLaw> table;
    HertzMindlinLaw& law = table.only();
    law.effectiveModulus = 1;
    law.effectiveModulus = stiffness / law.largestStiffness(meanRadius);
    law.effectiveShearModulus = tangentialShare / 4 * law.effectiveModulus;
    law.friction = coefficient;
    law.dampingRatio = 0.05;
    return table;
}

std::vector<GrainState> standingStill(std::vector<GrainState> states, const Bodies<2>& bodies)
{
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        states[i].position = bodies.pose[i].position;
        states[i].angle = bodies.pose[i].rotation.angle();
        states[i].velocity = Vector2::Zero();
        states[i].angularVelocity = 0;
    }
    return states;
}

/// That of the level heap whose centre of mass is as high, which needs no guess of where its surface is.
double solidFractionOf(const World& world, double area)
{
    double moment = 0;
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
        moment += world.areaOf(i) * world.bodies().pose[i].position.y();
    }
    return area * area / (2 * moment * world.walls()[2].point.x());
}

Rest relax(const Heap& heap, const ContactLaws& laws, double shareOfStable, double duration)
{
    WorldSettings settings = heap.settings;
    settings.contact = laws;
    World world(settings);
    world.updateForces();
    const double timeStep = shareOfStable * world.stableTimeStep();
    Rest rest;
    const double start = cpuSeconds();
    while (world.time() < duration)
    {
        stepOrThrow(world, timeStep);
    }
    rest.seconds = cpuSeconds() - start;
    rest.grains = standingStill(settings.grains, world.bodies());
    double area = 0;
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
        area += world.areaOf(i);
    }
    rest.solidFraction = solidFractionOf(world, area);
    rest.kinetic = kineticEnergy(world.bodies()) / (grainDensity * area * gravity * meanRadius);
    rest.overlap = world.largestRelativeOverlap();
    return rest;
}

Heap hardHeap(std::uint64_t seed)
{
    Heap heap;
    heap.settings = boxOfGrains({true, false}, grains, looseFraction, seed);
    heap.settings.energyLedger = false;
    heap.settings.gravity = Vector2(0, -gravity);
    heap.settings.localDamping = 0.5;
    heap.pressure = grainDensity * gravity * looseFraction * heap.settings.walls[2].point.x();
    heap.settings.grains = relax(heap, linearLaw(pouredLevel * heap.pressure, 0), 0.5, pouring).grains;
    // Harder grains come to rest sooner, as the root of their stiffness.
    for (double level = 10 * pouredLevel; level <= hardestLevel; level *= 10)
    {
        const double duration = 3 / std::sqrt(level);
        heap.settings.grains = relax(heap, linearLaw(level * heap.pressure, 0), 0.5, duration).grains;
    }
    const Rest hard =
        relax(heap, linearLaw(hardestLevel * heap.pressure, friction), 0.5, 40 / std::sqrt(hardestLevel));
    heap.hardFraction = hard.solidFraction;
    std::printf("    seed %d: solid fraction of hard grains %.7f, overlap %.1e, kinetic %.1e, %.1f s\n",
                static_cast<int>(seed), hard.solidFraction, hard.overlap, hard.kinetic, hard.seconds);
    return heap;
}

/// One row: medians of the heaps, largest kinetic energy left.
struct Level
{
    double error = 0;
    double overlap = 0;
    double kinetic = 0;
    double seconds = 0;
};

Level relaxAll(const std::vector<Heap>& heaps, LawOf law, double shareOfStable, double level)
{
    std::vector<double> errors;
    std::vector<double> overlaps;
    std::vector<double> seconds;
    Level result;
    for (const Heap& heap : heaps)
    {
        const Rest rest = relax(heap, law(level * heap.pressure, friction), shareOfStable, resting);
        errors.push_back(std::abs(rest.solidFraction / heap.hardFraction - 1));
        overlaps.push_back(rest.overlap);
        seconds.push_back(rest.seconds);
        result.kinetic = std::max(result.kinetic, rest.kinetic);
    }
    result.error = median(errors);
    result.overlap = median(overlaps);
    result.seconds = median(seconds);
    return result;
}

struct Sweep
{
    std::string name;
    LawOf law;
    double shareOfStable;
    double softest;
    double hardest;
    /// Every decade only.
    bool coarse;
};

/// "3e4".
std::string labelOf(double level)
{
    const int power = static_cast<int>(std::floor(std::log10(level)));
    return text("%ge%d", level / std::pow(10, power), power);
}

/// Order at which the error falls with the stiffness.
double sweepOver(const Sweep& sweep, const std::vector<Heap>& heaps, Results& results)
{
    std::vector<double> stiffness;
    std::vector<double> errors;
    std::vector<double> times;
    for (std::size_t i = 0; i < std::size(levels); i += sweep.coarse ? 2 : 1)
    {
        if (levels[i] < sweep.softest || levels[i] > sweep.hardest)
        {
            continue;
        }
        const Level found = relaxAll(heaps, sweep.law, sweep.shareOfStable, levels[i]);
        std::printf("    %-36s %-7g %9.2e  %8.1e  %8.1e  %7.3f\n", sweep.name.c_str(), levels[i], found.error,
                    found.overlap, found.kinetic, found.seconds);
        stiffness.push_back(levels[i]);
        errors.push_back(found.error);
        times.push_back(found.seconds);
        results.measurements.push_back({sweep.name, labelOf(levels[i]), found.error, found.seconds});
    }
    const double order = -logarithmicSlope(stiffness, errors);
    const std::string line = text("error ~ stiffness^%.2f, run time ~ stiffness^%.2f (%s)", -order,
                                  logarithmicSlope(stiffness, times), sweep.name.c_str());
    std::printf("    %s\n", line.c_str());
    results.comments.emplace_back("order", line);
    return order;
}

/// Standard deviation of one heap's solid fraction over the mean.
double scatterOf(const std::vector<Heap>& heaps)
{
    double sum = 0;
    double squares = 0;
    for (const Heap& heap : heaps)
    {
        sum += heap.hardFraction;
        squares += heap.hardFraction * heap.hardFraction;
    }
    const double count = static_cast<double>(heaps.size());
    return std::sqrt((squares - sum * sum / count) / (count - 1)) / (sum / count);
}

Results measure()
{
    std::vector<Heap> heaps;
    for (const std::uint64_t seed : seeds)
    {
        heaps.push_back(hardHeap(seed));
    }
    Results results;
    results.comments = {
        {"title", "Stiffness: solid fraction of a heap of irregular grains"},
        {"error", "solid fraction over that of hard grains, less 1 [-]"},
        {"time", text("run time of %g s of coming to rest [s]", resting)},
        {"knob", "stiffness over the pressure on the floor (Hertz: at the deepest overlap allowed)"},
        {"hard", text("the same heap at %g", hardestLevel)},
        {"median", text("of %zu seeds; %d polybeziers and ellipses", std::size(seeds), grains)},
        {"scatter",
         text("%.1e from heap to heap (standard deviation of hard heaps over their mean)", scatterOf(heaps))},
    };
    std::printf("    law                                  level       error   overlap   kinetic        s\n");
    const double linear =
        sweepOver({"linear, 1/2 stable step (automatic)", linearLaw, 0.5, 1e2, 1e5, false}, heaps, results);
    sweepOver({"linear, 1/4 stable step", linearLaw, 0.25, 1e2, 1e4, true}, heaps, results);
    const double hertz = sweepOver({"Hertz, 1/2 stable step", hertzLaw, 0.5, 1e3, 1e5, true}, heaps, results);
    sweepOver({"linear, whole stable step", linearLaw, 1, 1e2, 1e5, true}, heaps, results);
    test::record("dryEngine", "hardGrainOrder", linear, "-");
    test::record("dryEngine", "hardGrainOrderHertz", hertz, "-");
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
