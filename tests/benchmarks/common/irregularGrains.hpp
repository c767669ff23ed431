#pragma once

#include "core/measure/energy.hpp"
#include "core/world/randomInsertion.hpp"
#include "core/world/world.hpp"
#include "unit/randomGrain.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// Scenes of mixed irregular grains for the energy benchmarks.
namespace chesil::benchmark
{

/// Mean radius [m], density [kg/m3], contact stiffness [N/m].
constexpr double meanRadius = 0.01;
constexpr double grainDensity = 2650;
constexpr double contactStiffness = 1e6;

/// Which kinds of grains take part, in like numbers.
struct Kinds
{
    bool smooth = true;
    bool polygons = true;
};

/// Twelve of each kind, radii 0.7 to 1.3 of the mean one: polybeziers of 10 segments, ellipses of aspect ratio 1 to 2,
/// polygons of 4 to 7 sides.
inline std::vector<NamedShape> irregularShapes(const Kinds& kinds, test::RandomSource& random)
{
    std::vector<NamedShape> shapes;
    for (int i = 0; i < 12; ++i)
    {
        const std::string number = std::to_string(i);
        const double radius = meanRadius * random.uniform(0.7, 1.3);
        if (kinds.smooth)
        {
            test::RandomGrainOptions pebble;
            pebble.radius = radius;
            shapes.push_back({"pebble" + number, test::randomPolyBezier(pebble, random)});
            const double root = std::sqrt(random.uniform(0.5, 1));
            shapes.push_back({"egg" + number, Ellipse(radius / root, radius * root)});
        }
        if (kinds.polygons)
        {
            shapes.push_back({"tile" + number, test::randomPolygon(4 + i % 4, radius, random)});
        }
    }
    return shapes;
}

/// Undamped, frictionless and with a ledger; grains at random in a square box of fixed walls, at rest.
inline WorldSettings boxOfGrains(const Kinds& kinds, int number, double solidFraction, std::uint64_t seed)
{
    test::RandomSource random(seed);
    WorldSettings settings;
    settings.materials[0].density = grainDensity;
    settings.linear().normalStiffness = contactStiffness;
    settings.energyLedger = true;
    settings.shapes = irregularShapes(kinds, random);
    std::vector<int> shapeOfGrain;
    double area = 0;
    for (int i = 0; i < number; ++i)
    {
        const std::size_t shape = static_cast<std::size_t>(i) % settings.shapes.size();
        shapeOfGrain.push_back(static_cast<int>(shape));
        area += std::visit([](const auto& actual) { return actual.massProperties().area; }, settings.shapes[shape].shape);
    }
    const double side = std::sqrt(area / solidFraction);
    RandomEngine engine(seed);
    settings.grains = insertAtRandom(settings.shapes, shapeOfGrain, {Vector2(0, 0), Vector2(side, side)}, 0, engine);
    settings.walls = {
        {"floor", Vector2(0, 0), Vector2(0, 1)},
        {"left", Vector2(0, 0), Vector2(1, 0)},
        {"right", Vector2(side, 0), Vector2(-1, 0)},
        {"lid", Vector2(0, side), Vector2(0, -1)}};
    return settings;
}

/// Speed [m/s] at which a disk of the mean radius, halted by a wall, overlaps it by this share of its diameter.
inline double speedOfOverlap(double share)
{
    const double mass = grainDensity * M_PI * meanRadius * meanRadius;
    return share * 2 * meanRadius * std::sqrt(contactStiffness / mass);
}

/// Half to one and a half times `speed` [m/s] in any direction; spins up to that of a mean grain rolling at it.
inline void agitate(WorldSettings& settings, double speed, std::uint64_t seed)
{
    test::RandomSource random(seed);
    for (GrainState& grain : settings.grains)
    {
        grain.velocity = speed * random.uniform(0.5, 1.5) * random.direction();
        grain.angularVelocity = speed / meanRadius * random.uniform(-1, 1);
    }
}

/// Of the world's ledger now [J].
inline double residualOf(const World& world)
{
    return world.energyLedger()->residual(kineticEnergy(world.bodies()), world.contactEnergy());
}

/// Throws std::runtime_error, naming what went wrong.
inline void stepOrThrow(World& world, double timeStep)
{
    const StepStatus status = world.step(timeStep);
    if (status != StepStatus::done)
    {
        throw std::runtime_error(describe(status, world.brokenGrain()));
    }
}

} // namespace chesil::benchmark
