/// How well the energy ledger of a settling packing closes: grains with friction, restitution below 1 and local damping
/// fall into a heap. The residual over the work put in, and the order in the time step, from sweeps of its halvings.

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/common/irregularGrains.hpp"
#include "core/contact/restitution.hpp"
#include "unit/record.hpp"

#include <iterator>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr std::uint64_t seeds[] = {11, 12, 13};
constexpr int grains = 60;
constexpr int coarsest = 2;
constexpr int finest = 64;
/// Long enough to fall and come to rest [s].
constexpr double duration = 0.6;

struct Settling
{
    double residual = 0;
    double seconds = 0;
    /// Kinetic energy at the end over the work put in.
    double kinetic = 0;
};

WorldSettings fallingGrains(const Kinds& kinds, std::uint64_t seed)
{
    WorldSettings settings = boxOfGrains(kinds, grains, 0.3, seed);
    settings.gravity = Vector2(0, -9.81);
    settings.linear().tangentialStiffness = 0.8 * contactStiffness;
    settings.linear().friction = 0.5;
    settings.linear().dampingRatio = dampingRatioOf(0.5);
    settings.localDamping = 0.1;
    return settings;
}

/// The largest residual on the way over the work that gravity has done until the end.
Settling settle(const WorldSettings& settings, int division)
{
    World world(settings);
    world.updateForces();
    const double timeStep = world.stableTimeStep() / division;
    const long steps = std::lround(duration / timeStep);
    Settling result;
    const double start = cpuSeconds();
    for (long i = 1; i <= steps; ++i)
    {
        stepOrThrow(world, timeStep);
        if (i % (10 * division) == 0 || i == steps)
        {
            result.residual = std::max(result.residual, std::abs(residualOf(world)));
        }
    }
    result.seconds = cpuSeconds() - start;
    const double work = world.energyLedger()->start + world.energyLedger()->works();
    result.residual /= work;
    result.kinetic = kineticEnergy(world.bodies()) / work;
    return result;
}

/// Of the seeds: median residual and run time, largest kinetic energy left.
Settling settleAll(const Kinds& kinds, int division)
{
    std::vector<double> residuals;
    std::vector<double> seconds;
    Settling result;
    for (const std::uint64_t seed : seeds)
    {
        const Settling one = settle(fallingGrains(kinds, seed), division);
        residuals.push_back(one.residual);
        seconds.push_back(one.seconds);
        result.kinetic = std::max(result.kinetic, one.kinetic);
    }
    result.residual = median(residuals);
    result.seconds = median(seconds);
    return result;
}

/// Recorded under names with this ending.
void sweep(const std::string& name, const Kinds& kinds, const std::string& ending, Results& results)
{
    std::vector<double> steps;
    std::vector<double> residuals;
    for (int division = coarsest; division <= finest; division *= 2)
    {
        const Settling run = settleAll(kinds, division);
        std::printf(
            "    %-22s 1/%-4d %8.1e  %8.1e  %6.2f\n", name.c_str(), division, run.residual, run.kinetic, run.seconds);
        steps.push_back(1.0 / division);
        residuals.push_back(run.residual);
        results.measurements.push_back({name, text("1/%d", division), run.residual, run.seconds});
    }
    const double order = logarithmicSlope(steps, residuals);
    const std::string line = text("residual ~ step^%.2f (%s)", order, name.c_str());
    std::printf("    %s\n", line.c_str());
    results.comments.emplace_back("order", line);
    test::record("dryEngine", "settlingResidual" + ending, residuals.back(), "-");
    test::record("dryEngine", "settlingOrder" + ending, order, "-");
}

Results measure()
{
    Results results;
    results.comments = {
        {"title", "Energy ledger of a settling packing with friction and damping"},
        {"error", "largest residual of the ledger over the work put in [-]"},
        {"time", "run time of one run [s]"},
        {"knob", "time step over the stable one"},
        {"median", text("of %zu seeds; %d grains, %g s", std::size(seeds), grains, duration)},
    };
    std::printf("    grains                 step   residual   kinetic       s\n");
    sweep("all kinds", {true, true}, "", results);
    sweep("without straight sides", {true, false}, "Smooth", results);
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
