#pragma once

#include "benchmarks/dryThroughput/scene.hpp"

#include <memory>

/// Dense packings, relaxed and sheared into a steady flow by our engine.
namespace chesil::benchmark
{

inline void runSteps(World& world, double timeStep, int steps)
{
    for (int step = 0; step < steps; ++step)
    {
        // Grains are scattered inside each other at first; how they get apart does not matter here.
        const StepStatus status = world.step(timeStep);
        if (status != StepStatus::done && status != StepStatus::tooDeep)
        {
            throw std::runtime_error(describe(status, world.brokenGrain()));
        }
    }
}

/// The scene as the world has it now.
inline void takeOver(const World& world, Scene& scene)
{
    if (world.cell())
    {
        scene.first = world.cell()->cell.first();
        scene.second = world.cell()->cell.second();
    }
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        const Pose<2>& pose = world.bodies().pose[i];
        scene.grains[i].position = pose.position;
        scene.grains[i].angle = pose.rotation.angle();
        scene.grains[i].velocity = world.bodies().velocity[i];
        scene.grains[i].angularVelocity = world.bodies().angularVelocity[i];
    }
    if (world.cell())
    {
        wrap(scene);
    }
}

/// Pushes overlaps apart: without friction, with drag.
inline void relax(Scene& scene, int steps)
{
    WorldSettings settings = settingsOf(scene);
    settings.linear().friction = 0;
    settings.linear().dampingRatio = 0.5;
    settings.viscousDamping = 2;
    if (settings.cell)
    {
        settings.cell->velocityGradient.setZero();
    }
    for (PlaneWall<2>& wall : settings.walls)
    {
        wall.motion = FixedWall();
    }
    for (GrainState& grain : settings.grains)
    {
        grain.velocity.setZero();
        grain.angularVelocity = 0;
    }
    World world(settings);
    runSteps(world, world.stableTimeStep(), steps);
    takeOver(world, scene);
}

/// To the given strain at the scene's rate.
inline void shear(Scene& scene, double strain)
{
    WorldSettings settings = settingsOf(scene);
    if (settings.cell)
    {
        for (GrainState& grain : settings.grains)
        {
            grain.velocity.setZero();
        }
    }
    World world(settings);
    const int steps = static_cast<int>(std::ceil(strain / shearRate / world.stableTimeStep()));
    runSteps(world, strain / shearRate / steps, steps);
    takeOver(world, scene);
    std::printf("    packed %zu grains: %.2f contacts a grain, largest overlap %.1e of the smaller grain\n",
                scene.grains.size(), contactsAGrain(world), world.largestRelativeOverlap());
}

/// Grains near the places of a square lattice, all templates as often, in a square cell of this solid
/// fraction.
inline Scene scattered(Grains kind, int number, double solidFraction)
{
    RandomEngine engine(templateSeed);
    Scene scene;
    scene.kind = kind;
    const int rows = static_cast<int>(std::sqrt(number));
    const int columns = (number + rows - 1) / rows;
    double area = 0;
    for (int i = 0; i < number; ++i)
    {
        GrainState grain;
        grain.shape = i % templates;
        grain.angle = 2 * M_PI * uniform(engine);
        grain.position =
            Vector2((i % columns + uniform(engine)) / columns, (i / columns + uniform(engine)) / rows);
        scene.grains.push_back(grain);
        area += templateArea(grain.shape);
    }
    const double side = std::sqrt(area / solidFraction);
    std::vector<Vector2> places;
    for (const GrainState& grain : scene.grains)
    {
        places.push_back(side * grain.position);
    }
    shuffle(places, engine);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        scene.grains[i].position = places[i];
    }
    scene.first = Vector2(side, 0);
    scene.second = Vector2(0, side);
    return scene;
}

inline Scene flowingCell(Grains kind, int number, double solidFraction)
{
    Scene scene = scattered(kind, number, solidFraction);
    relax(scene, 4000);
    shear(scene, 0.04);
    return scene;
}

/// The grains of a cell in a box whose walls stand `margin` [m] outside of their centroids' rectangle.
inline Scene boxed(Scene scene, double margin)
{
    scene.bounds = Bounds::walls;
    wrap(scene);
    scene.first = Vector2(scene.first.x() + 2 * margin, 0);
    scene.second = Vector2(0, scene.second.y() + 2 * margin);
    for (GrainState& grain : scene.grains)
    {
        grain.position += Vector2(margin, margin);
    }
    relax(scene, 2000);
    shear(scene, 0.002);
    return scene;
}

} // namespace chesil::benchmark
