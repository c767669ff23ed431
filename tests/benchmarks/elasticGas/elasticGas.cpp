/// Energy of a frictionless elastic gas of irregular grains over many steps: residual of the ledger and its drift, over a
/// sweep of the time step.

#include "benchmarks/common/benchmark.hpp"
#include "core/measure/energy.hpp"
#include "core/world/randomInsertion.hpp"
#include "core/world/world.hpp"
#include "unit/randomGrain.hpp"
#include "unit/record.hpp"

#include <cstdint>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr std::uint64_t seed = 20261123;
constexpr int grains = 500;
constexpr double radius = 0.01;
/// Share of the box that grains cover, speed of the grains [m/s], their contact stiffness [N/m] and density [kg/m3].
constexpr double solidFraction = 0.3;
constexpr double speed = 0.1;
constexpr double stiffness = 1e7;
constexpr double density = 2650;
constexpr int samples = 200;
/// Of the stable step, in the long run.
constexpr int longRunDivision = 128;

/// Ten-segment polybeziers, ellipses and, if asked, polygons with four to seven sides: as many of each kind.
std::vector<NamedShape> gasShapes(bool withPolygons, test::RandomSource& random)
{
    std::vector<NamedShape> shapes;
    for (int k = 0; k < 8; ++k)
    {
        test::RandomGrainOptions options;
        options.radius = radius;
        shapes.push_back({"polybezier" + std::to_string(k), randomPolyBezier(options, random)});
        shapes.push_back({"ellipse" + std::to_string(k), Ellipse(random.uniform(1, 1.5) * radius, radius)});
        if (withPolygons)
        {
            shapes.push_back({"polygon" + std::to_string(k), test::randomPolygon(4 + k % 4, radius, random)});
        }
    }
    return shapes;
}

WorldSettings gas(bool withPolygons)
{
    test::RandomSource random(seed);
    WorldSettings settings;
    settings.shapes = gasShapes(withPolygons, random);
    settings.materials[0].density = density;
    settings.linear().normalStiffness = stiffness;
    settings.energyLedger = true;
    std::vector<int> shapeOfGrain;
    double area = 0;
    for (int i = 0; i < grains; ++i)
    {
        shapeOfGrain.push_back(i % static_cast<int>(settings.shapes.size()));
        area += massProperties(settings.shapes[static_cast<std::size_t>(shapeOfGrain.back())].shape).area;
    }
    const double side = std::sqrt(area / solidFraction);
    const PlacementBox box{Vector2::Zero(), Vector2(side, side)};
    RandomEngine engine(seed);
    settings.grains = insertAtRandom(settings.shapes, shapeOfGrain, box, 1e-4, engine);
    for (GrainState& grain : settings.grains)
    {
        grain.velocity = speed * random.direction();
        grain.angularVelocity = random.uniform(-1, 1) * speed / radius;
    }
    settings.walls = {{"floor", box.lower, Vector2::UnitY()},
                      {"left", box.lower, Vector2::UnitX()},
                      {"lid", box.upper, -Vector2::UnitY()},
                      {"right", box.upper, -Vector2::UnitX()}};
    return settings;
}

struct Energies
{
    double largest = 0;
    double last = 0;
    /// What a straight line through the residuals gains from the start to the end, and their scatter about it.
    double drift = 0;
    double scatter = 0;
    double seconds = 0;
};

void fitLine(const std::vector<double>& values, Energies& energies)
{
    const double count = static_cast<double>(values.size());
    double sum = 0, sumX = 0, sumXX = 0, sumXY = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        const double x = static_cast<double>(i) / (count - 1);
        sum += values[i];
        sumX += x;
        sumXX += x * x;
        sumXY += x * values[i];
    }
    energies.drift = (count * sumXY - sumX * sum) / (count * sumXX - sumX * sumX);
    const double start = (sum - energies.drift * sumX) / count;
    double squares = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        const double rest = values[i] - start - energies.drift * static_cast<double>(i) / (count - 1);
        squares += rest * rest;
    }
    energies.scatter = std::sqrt(squares / count);
}

/// Residuals are shares of the energy at the start.
Energies runGas(const WorldSettings& settings, double share, long steps)
{
    World world(settings);
    world.updateForces();
    const double timeStep = share * world.stableTimeStep();
    const double start = cpuSeconds();
    std::vector<double> residuals;
    Energies energies;
    for (int sample = 0; sample < samples; ++sample)
    {
        for (long step = 0; step < steps / samples; ++step)
        {
            if (world.step(timeStep) != StepStatus::done)
            {
                throw std::runtime_error("the gas has broken down");
            }
        }
        const EnergyLedger& ledger = *world.energyLedger();
        residuals.push_back(ledger.residual(kineticEnergy(world.bodies()), world.contactEnergy()) / ledger.start);
        energies.largest = std::max(energies.largest, std::abs(residuals.back()));
    }
    energies.last = residuals.back();
    energies.seconds = cpuSeconds() - start;
    fitLine(residuals, energies);
    return energies;
}

Energies addRow(const std::string& name, const WorldSettings& settings, int division, long steps, Results& results)
{
    const Energies found = runGas(settings, 1.0 / division, steps);
    std::printf("    %-32s 1/%-4d %8ld steps  largest %8.1e  end %9.1e  drift %9.1e  scatter %8.1e  %6.1f s\n", name.c_str(), division,
                steps, found.largest, found.last, found.drift, found.scatter, found.seconds);
    results.measurements.push_back({name, text("1/%d", division), found.largest, found.seconds});
    return found;
}

/// The same stretch of time at ever smaller steps, then the long run.
Results measure()
{
    std::printf("    seed %llu\n", static_cast<unsigned long long>(seed));
    Results results;
    results.comments = {
        {"title", "Frictionless elastic gas of 500 irregular grains"},
        {"error", "largest residual of the energy ledger over the energy at the start [-]"},
        {"time", "run time on one core [s]"},
        {"knob", "time step over the stable one"},
        {"seed", std::to_string(seed)},
    };
    for (const bool withPolygons : {false, true})
    {
        const WorldSettings settings = gas(withPolygons);
        const std::string name = withPolygons ? "with polygons" : "polybeziers and ellipses";
        std::vector<double> steps;
        std::vector<double> errors;
        for (int division = 4; division <= 256; division *= 4)
        {
            errors.push_back(addRow(name, settings, division, 2000L * division, results).largest);
            steps.push_back(1.0 / division);
        }
        const std::string order = text("error ~ step^%.2f (%s)", logarithmicSlope(steps, errors), name.c_str());
        std::printf("    %s\n", order.c_str());
        results.comments.emplace_back("order", order);
    }
    const Energies found = addRow("with polygons, 10^6 steps", gas(true), longRunDivision, 1000000, results);
    test::record("dryEngine", "gasEnergyResidual", found.largest, "-");
    test::record("dryEngine", "gasEnergyDrift", std::abs(found.drift), "-");
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
