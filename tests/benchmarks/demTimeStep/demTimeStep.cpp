/// What a smaller time step buys: the energy of frictionless, undamped ellipses that bounce on a floor, or
/// off each other in free space. Nothing takes energy out; what changes it is the time step.

#include "benchmarks/demTimeStep/energyRun.hpp"
#include "core/base/tolerances.hpp"
#include "unit/randomGrain.hpp"

#include <cstdint>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr std::uint64_t seed = 20240613;
constexpr int finest = 256;
/// Half-axes [m], density [kg/m3], contact stiffness [N/m].
constexpr double longAxis = 0.01;
constexpr double shortAxis = 0.005;
constexpr double density = 2650;
constexpr double stiffness = 1e7;

/// Many starts of one problem, each run by itself over the same physical time.
struct Problem
{
    std::string method;
    std::vector<WorldSettings> starts;
    int samples;
    /// Of the largest stable step.
    int stepsBetween;
    /// With several contacts in one run, the largest error and the last are not the same.
    bool severalContacts;
};

WorldSettings ellipseSettings()
{
    WorldSettings settings;
    settings.shapes.push_back({"ellipse", Ellipse(longAxis, shortAxis)});
    settings.materials[0].density = density;
    settings.linear().normalStiffness = stiffness;
    return settings;
}

/// Dropped with their lowest point about one length above the floor, at any angle.
Problem bouncingEllipse(int count)
{
    Problem problem{"bounces on a floor", {}, 1500, 16, true};
    test::RandomSource random(seed);
    for (int i = 0; i < count; ++i)
    {
        WorldSettings settings = ellipseSettings();
        settings.walls.push_back({"floor", Vector2::Zero(), Vector2::UnitY()});
        settings.gravity = Vector2(0, -9.81);
        GrainState grain;
        grain.position = Vector2(0, random.uniform(0.028, 0.032));
        grain.angle = random.uniform(-M_PI, M_PI);
        settings.grains.push_back(grain);
        problem.starts.push_back(settings);
    }
    return problem;
}

/// Two that fly at each other, at any angles and off centre, and spin. The floor's contact is exact, that of
/// two ellipses comes from EPA, whose tolerance on the depth leaves about its root, in rad, in the normal:
/// 1e-9 would show in the energy below 1e-6.
Problem collidingEllipses(int count)
{
    Problem problem{"collision of two", {}, 100, 8, false};
    test::RandomSource random(seed);
    for (int i = 0; i < count; ++i)
    {
        WorldSettings settings = ellipseSettings();
        for (const double side : {-1.0, 1.0})
        {
            GrainState grain;
            grain.position = Vector2(side * 1.01 * longAxis, side * random.uniform(-0.2, 0.2) * shortAxis);
            grain.angle = random.uniform(-M_PI, M_PI);
            grain.velocity = Vector2(-side * 0.4, 0);
            grain.angularVelocity = random.uniform(-40, 40);
            settings.grains.push_back(grain);
        }
        problem.starts.push_back(settings);
    }
    return problem;
}

/// What the runs with one time step, stable/division, gave: an entry for each start.
struct Runs
{
    int division;
    std::vector<double> largest;
    std::vector<double> last;
    std::vector<double> seconds;
};

/// All steps of a start before the next start, so that a busy moment of the machine hits them alike.
std::vector<Runs> runAll(const Problem& problem, double stable)
{
    std::vector<Runs> all;
    for (int division = 1; division <= finest; division *= 2)
    {
        all.push_back({division, {}, {}, {}});
    }
    runWorld(problem.starts.front(), stable, problem.samples, problem.stepsBetween); // warms up
    for (const WorldSettings& start : problem.starts)
    {
        for (Runs& runs : all)
        {
            const EnergyErrors errors = runWorld(start, stable / runs.division, problem.samples,
                                                 runs.division * problem.stepsBetween);
            runs.largest.push_back(errors.largest);
            runs.last.push_back(errors.last);
            runs.seconds.push_back(errors.seconds);
        }
    }
    return all;
}

void measureProblem(const Problem& problem, Results& results)
{
    const double stable = World(problem.starts.front()).stableTimeStep();
    std::printf("    %s: %zu starts, %.3g s each, stable step %.3g s ...\n", problem.method.c_str(),
                problem.starts.size(), stable * problem.samples * problem.stepsBetween, stable);
    const std::vector<Runs> all = runAll(problem, stable);

    std::printf("    step/stable    largest      last    seconds a run\n");
    const std::string largestName = problem.method + (problem.severalContacts ? ", largest" : "");
    std::vector<double> steps;
    std::vector<double> largestErrors;
    std::vector<Results::Measurement> lastRows;
    for (const Runs& runs : all)
    {
        const std::string knob = runs.division == 1 ? "1" : text("1/%d", runs.division);
        const double last = median(runs.last);
        const double seconds = median(runs.seconds);
        steps.push_back(1.0 / runs.division);
        largestErrors.push_back(median(runs.largest));
        results.measurements.push_back({largestName, knob, largestErrors.back(), seconds});
        if (problem.severalContacts)
        {
            lastRows.push_back({problem.method + ", at the end", knob, last, seconds});
        }
        std::printf("    %-11s    %7.1e   %7.1e   %10.2e\n", knob.c_str(), largestErrors.back(), last,
                    seconds);
    }
    results.measurements.insert(results.measurements.end(), lastRows.begin(), lastRows.end());

    const std::string order =
        text("error ~ step^%.2f (%s)", logarithmicSlope(steps, largestErrors), largestName.c_str());
    std::printf("    %s\n", order.c_str());
    results.comments.emplace_back("order", order);
}

Results measure()
{
    std::printf("    seed %llu\n", static_cast<unsigned long long>(seed));
    Results results;
    results.comments = {
        {"title", "Time step: energy of frictionless, undamped ellipses"},
        {"error", "relative error of the energy [-]"},
        {"time", "run time of one run [s]"},
        {"knob", "time step over the stable one"},
        {"median", "of the runs: of the error over the energy at the start, and of the CPU time"},
        {"epa", text("tolerance %g", tolerances::expandingPolytope)},
        {"seed", std::to_string(seed)},
    };
    measureProblem(bouncingEllipse(24), results);
    measureProblem(collidingEllipses(100), results);
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
