/// What a smaller time step buys in a gas of irregular grains: errors of the energy and of the trajectories, the latter
/// against a much finer run, over so short a time that chaos has not taken over.

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/common/irregularGrains.hpp"

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr std::uint64_t seed = 20261123;
constexpr int grains = 200;
constexpr double solidFraction = 0.4;
constexpr double overlap = 0.01;
/// In stable steps: a mean grain goes about one radius.
constexpr int duration = 400;
constexpr int coarsest = 2;
constexpr int finest = 256;
constexpr int reference = 2048;

struct Run
{
    std::vector<Vector2> positions;
    double energyError = 0;
    double seconds = 0;
};

Run runGas(const WorldSettings& settings, int division)
{
    World world(settings);
    world.updateForces();
    const double timeStep = world.stableTimeStep() / division;
    Run run;
    const double start = cpuSeconds();
    for (int i = 0; i < duration * division; ++i)
    {
        stepOrThrow(world, timeStep);
    }
    run.seconds = cpuSeconds() - start;
    run.energyError = std::abs(residualOf(world)) / world.energyLedger()->start;
    for (const Pose<2>& pose : world.bodies().pose)
    {
        run.positions.push_back(pose.position);
    }
    return run;
}

/// Root mean square over the grains, in mean radii.
double distance(const Run& one, const Run& other)
{
    double squares = 0;
    for (std::size_t i = 0; i < one.positions.size(); ++i)
    {
        squares += (one.positions[i] - other.positions[i]).squaredNorm();
    }
    return std::sqrt(squares / static_cast<double>(one.positions.size())) / meanRadius;
}

/// Prints the order of a curve and adds it to the results.
void noteOrder(const std::string& name, const std::vector<double>& steps, const std::vector<double>& errors, Results& results)
{
    const std::string line = text("error ~ step^%.2f (%s)", logarithmicSlope(steps, errors), name.c_str());
    std::printf("    %s\n", line.c_str());
    results.comments.emplace_back("order", line);
}

void sweep(const std::string& name, const Kinds& kinds, Results& results)
{
    WorldSettings settings = boxOfGrains(kinds, grains, solidFraction, seed);
    agitate(settings, speedOfOverlap(overlap), seed);
    const Run best = runGas(settings, reference);
    std::vector<double> steps;
    std::vector<double> energies;
    std::vector<double> distances;
    std::vector<Results::Measurement> trajectories;
    for (int division = coarsest; division <= finest; division *= 2)
    {
        const Run run = runGas(settings, division);
        const std::string knob = text("1/%d", division);
        steps.push_back(1.0 / division);
        energies.push_back(run.energyError);
        distances.push_back(distance(run, best));
        results.measurements.push_back({"energy, " + name, knob, energies.back(), run.seconds});
        trajectories.push_back({"trajectory, " + name, knob, distances.back(), run.seconds});
        std::printf("    %-22s %-6s %8.1e  %8.1e  %8.3f\n", name.c_str(), knob.c_str(), energies.back(), distances.back(),
                    run.seconds);
    }
    results.measurements.insert(results.measurements.end(), trajectories.begin(), trajectories.end());
    noteOrder("energy, " + name, steps, energies, results);
    noteOrder("trajectory, " + name, steps, distances, results);
}

Results measure()
{
    Results results;
    results.comments = {
        {"title", "Time step in an elastic gas of irregular grains"},
        {"error", "energy over that at the start; rms distance from the finest run [mean radii]"},
        {"time", "run time of one run [s]"},
        {"knob", "time step over the stable one"},
        {"reference", text("1/%d of the stable step; %d grains, %d stable steps long", reference, grains, duration)},
        {"seed", std::to_string(seed)},
    };
    std::printf("    grains                 step     energy  trajectory       s\n");
    sweep("all kinds", {true, true}, results);
    sweep("without straight sides", {true, false}, results);
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
