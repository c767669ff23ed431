/// How well a frictionless elastic gas of irregular grains keeps its energy over 10^6 steps: the ledger's residual over
/// the energy at the start. The bar of issue 4 is measured with all kinds of grains; those without straight sides are run
/// beside them, to tell what the time step costs from what flat contacts do.

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/common/drift.hpp"
#include "benchmarks/common/irregularGrains.hpp"
#include "unit/record.hpp"

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr std::uint64_t seeds[] = {20261123, 20261124, 20261125};
constexpr int grains = 500;
constexpr double solidFraction = 0.4;
/// Typical of a collision, over the diameter: of the bar, and of slower gases beside it.
constexpr double overlap = 0.01;
constexpr double slowerOverlaps[] = {0.003, 0.001};
constexpr int longSteps = 1000000;
constexpr int samples = 2000;
/// Of the stable step, for the run of 10^6 steps.
constexpr int divisionOfLongRun = 100;

struct Gas
{
    std::string name;
    Kinds kinds;
};

struct GasRun
{
    double largest = 0;
    double last = 0;
    Drift drift;
    double seconds = 0;
    /// Way of a mean grain over its radius.
    double way = 0;
};

GasRun runGas(const Gas& gas, double ofCollision, std::uint64_t seed, int division, int steps)
{
    WorldSettings settings = boxOfGrains(gas.kinds, grains, solidFraction, seed);
    const double speed = speedOfOverlap(ofCollision);
    agitate(settings, speed, seed);
    World world(settings);
    world.updateForces();
    const double timeStep = world.stableTimeStep() / division;
    std::vector<double> residuals;
    GasRun run;
    const double start = cpuSeconds();
    for (int i = 1; i <= steps; ++i)
    {
        stepOrThrow(world, timeStep);
        if (i % (steps / samples) == 0)
        {
            residuals.push_back(residualOf(world) / world.energyLedger()->start);
            run.largest = std::max(run.largest, std::abs(residuals.back()));
        }
    }
    run.seconds = cpuSeconds() - start;
    run.last = std::abs(residuals.back());
    run.drift = driftOf(residuals);
    run.way = steps * timeStep * speed / meanRadius;
    return run;
}

void print(const Gas& gas, int division, int steps, const GasRun& run)
{
    std::printf(
        "    %-22s 1/%-4d %8d  %8.1e  %8.1e  %8.1e  %5.1f  %6.1f  %6.1f\n", gas.name.c_str(), division, steps, run.largest,
        run.last, run.drift.change, run.drift.significance, run.way, run.seconds);
}

/// The same stretch of time at ever finer steps.
void sweep(const Gas& gas, Results& results)
{
    std::vector<double> steps;
    std::vector<double> errors;
    for (int division = 5; division <= 160; division *= 2)
    {
        const GasRun run = runGas(gas, overlap, seeds[0], division, 2000 * division);
        print(gas, division, 2000 * division, run);
        steps.push_back(1.0 / division);
        errors.push_back(run.largest);
        results.measurements.push_back({gas.name, text("1/%d", division), run.largest, run.seconds});
    }
    const std::string order = text("residual ~ step^%.2f (%s)", logarithmicSlope(steps, errors), gas.name.c_str());
    std::printf("    %s\n", order.c_str());
    results.comments.emplace_back("order", order);
}

/// 10^6 steps from each seed: the worst of each figure.
GasRun runLong(const Gas& gas, double ofCollision, Results& results)
{
    GasRun worst;
    std::printf("    overlaps of %g diameters:\n", ofCollision);
    for (const std::uint64_t seed : seeds)
    {
        const GasRun run = runGas(gas, ofCollision, seed, divisionOfLongRun, longSteps);
        print(gas, divisionOfLongRun, longSteps, run);
        results.measurements.push_back({gas.name, text("%g", ofCollision), run.largest, run.seconds});
        results.comments.emplace_back(
            "long run", text("%s, overlap %g: largest %.2e, end %.2e, drift %.1e (t = %.1f), way %.0f radii", gas.name.c_str(),
                             ofCollision, run.largest, run.last, run.drift.change, run.drift.significance, run.way));
        worst.largest = std::max(worst.largest, run.largest);
        worst.drift.significance = std::max(worst.drift.significance, std::abs(run.drift.significance));
    }
    return worst;
}

/// Under names with this ending.
void recordBars(const GasRun& worst, const std::string& ending)
{
    test::record("dryEngine", "gasEnergyResidual" + ending, worst.largest, "-");
    test::record("dryEngine", "gasEnergyDrift" + ending, worst.drift.significance, "-");
}

Results measureLong(const Gas& all, const Gas& smooth)
{
    Results results;
    results.suffix = "Long";
    results.comments = {
        {"title", "Energy of an elastic gas over 10^6 steps, three seeds each"},
        {"error", "largest residual of the ledger over the energy at the start [-]"},
        {"time", "run time of one run [s]"},
        {"knob", "overlap of a typical collision over the diameter"},
        {"drawing", "points"},
        {"step", text("1/%d of the stable one", divisionOfLongRun)},
    };
    recordBars(runLong(all, overlap, results), "");
    recordBars(runLong(smooth, overlap, results), "Smooth");
    for (const double slower : slowerOverlaps)
    {
        runLong(all, slower, results);
    }
    return results;
}

Results measure()
{
    const Gas all{"all kinds", {true, true}};
    const Gas smooth{"without straight sides", {true, false}};
    const Gas polygons{"polygons alone", {false, true}};
    Results results;
    results.comments = {
        {"title", "Energy of a frictionless elastic gas of irregular grains"},
        {"error", "largest residual of the ledger over the energy at the start [-]"},
        {"time", "run time of one run [s]"},
        {"knob", "time step over the stable one"},
        {"gas", text("%d grains, solid fraction %g, overlaps of about %g diameters", grains, solidFraction, overlap)},
        {"seed", std::to_string(seeds[0])},
    };
    std::printf("    gas                    step      steps   largest    at end    change      t     way       s\n");
    for (const Gas& gas : {all, smooth, polygons})
    {
        sweep(gas, results);
    }
    results.beside.push_back(measureLong(all, smooth));
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
