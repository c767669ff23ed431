/// How well the energy ledger of a settling packing closes: grains with friction, restitution below 1 and
/// local damping fall into a heap. The residual over the work put in, and its order in the time step.
/// Dashpots look ahead in coarse steps only (decision 18), with errors of about a quarter: where that ends
/// the residual jumps, so each scheme has its own sweep.

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/common/irregularGrains.hpp"
#include "core/contact/restitution.hpp"
#include "unit/record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

/// Seeds from here on; more of them where the step is coarse: the residuals scatter more, and the runs are
/// short.
constexpr std::uint64_t firstSeed = 11;
constexpr std::size_t seeds = 3;
constexpr std::size_t seedsLookingAhead = 8;
constexpr int grains = 60;
constexpr double restitution = 0.5;
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
    settings.linear().dampingRatio = dampingRatioOf(restitution);
    settings.localDamping = 0.1;
    return settings;
}

/// The largest residual on the way over the work that gravity has done until the end.
Settling settle(const WorldSettings& settings, double division)
{
    World world(settings);
    world.updateForces();
    const double timeStep = world.stableTimeStep() / division;
    const long steps = std::lround(duration / timeStep);
    const long between = std::lround(10 * division);
    Settling result;
    const double start = cpuSeconds();
    for (long i = 1; i <= steps; ++i)
    {
        stepOrThrow(world, timeStep);
        if (i % between == 0 || i == steps)
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

/// Division of the stable step above which no dashpot looks ahead: the step brakes by no more than 1 %
/// (World::anticipate).
double endOfLookAhead(const WorldSettings& settings)
{
    const World world(settings);
    const std::vector<double>& inverseMass = world.bodies().inverseMass;
    const double lightest = *std::max_element(inverseMass.begin(), inverseMass.end());
    const double rate = dampingRatioOf(restitution) * std::sqrt(2 * contactStiffness * lightest);
    return rate * world.stableTimeStep() / 0.01;
}

struct Order
{
    double mean;
    double standardError;
};

Order meanOf(const std::vector<double>& orders)
{
    const double count = static_cast<double>(orders.size());
    double sum = 0;
    double squares = 0;
    for (const double order : orders)
    {
        sum += order;
        squares += order * order;
    }
    const double mean = sum / count;
    return {mean, std::sqrt((squares / count - mean * mean) / (count - 1))};
}

/// Adds the medians of the seeds to the results; gives the order in the step, the mean of the seeds' own.
Order sweep(const std::string& name, const Kinds& kinds, const std::vector<double>& divisions,
            std::size_t count, Results& results)
{
    std::vector<double> steps;
    std::vector<std::vector<double>> residuals(count);
    for (const double division : divisions)
    {
        std::vector<double> now;
        std::vector<double> seconds;
        double kinetic = 0;
        std::printf("    %-38s 1/%-5.3g", name.c_str(), division);
        for (std::size_t k = 0; k < count; ++k)
        {
            const Settling run = settle(fallingGrains(kinds, firstSeed + k), division);
            now.push_back(run.residual);
            residuals[k].push_back(run.residual);
            seconds.push_back(run.seconds);
            kinetic = std::max(kinetic, run.kinetic);
            std::printf("  %8.2e", run.residual);
        }
        std::printf("  %8.1e  %6.2f\n", kinetic, median(seconds));
        steps.push_back(1.0 / division);
        results.measurements.push_back({name, text("1/%.3g", division), median(now), median(seconds)});
    }
    std::vector<double> orders;
    for (const std::vector<double>& ofOne : residuals)
    {
        orders.push_back(logarithmicSlope(steps, ofOne));
    }
    std::printf("    %-38s  order", name.c_str());
    for (const double order : orders)
    {
        std::printf("  %8.3f", order);
    }
    std::printf("\n");
    const Order order = meanOf(orders);
    const std::string line =
        text("residual ~ step^%.3f +- %.3f (%s)", order.mean, order.standardError, name.c_str());
    std::printf("    %s\n", line.c_str());
    results.comments.emplace_back("order", line);
    return order;
}

/// Divisions from `low` on by this factor, up to `high`.
std::vector<double> divisionsFrom(double low, double high, double factor)
{
    std::vector<double> divisions;
    for (double division = low; division <= high * (1 + 1e-9); division *= factor)
    {
        divisions.push_back(division);
    }
    return divisions;
}

/// Recorded under names with this ending; the order is the lower one of the schemes that a factor of 2 at
/// least in the step has room for.
void sweepAll(const std::string& name, const Kinds& kinds, const std::string& ending, Results& results)
{
    std::vector<double> ends;
    for (std::size_t k = 0; k < seedsLookingAhead; ++k)
    {
        ends.push_back(endOfLookAhead(fallingGrains(kinds, firstSeed + k)));
    }
    const auto [first, last] = std::minmax_element(ends.begin(), ends.end());
    double lowest = std::numeric_limits<double>::infinity();
    if (*first >= 2)
    {
        const std::vector<double> divisions = divisionsFrom(1, *first, std::sqrt(std::sqrt(2.0)));
        lowest = sweep(name + ", looking ahead", kinds, divisions, seedsLookingAhead, results).mean;
    }
    const double coarsest = std::exp2(std::ceil(std::log2(*last)));
    lowest = std::min(lowest, sweep(name, kinds, divisionsFrom(coarsest, finest, 2), seeds, results).mean);
    test::record("dryEngine", "settlingResidual" + ending, results.measurements.back().error, "-");
    test::record("dryEngine", "settlingOrder" + ending, lowest, "-");
}

Results measure()
{
    Results results;
    results.comments = {
        {"title", "Energy ledger of a settling packing with friction and damping"},
        {"error", "largest residual of the ledger over the work put in [-]"},
        {"time", "run time of one run [s]"},
        {"knob", "time step over the stable one"},
        {"median", text("of %zu seeds (looking ahead: %zu); %d grains, %g s", seeds, seedsLookingAhead,
                        grains, duration)},
    };
    std::printf("    grains                                 step     residual of each seed          kinetic  "
                "     s\n");
    sweepAll("all kinds", {true, true}, "", results);
    sweepAll("without straight sides", {true, false}, "Smooth", results);
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
