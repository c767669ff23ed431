#pragma once

#include "core/world/placement.hpp"
#include "core/world/world.hpp"
#include "unit/randomGrain.hpp"

#include <stdexcept>
#include <string>

/// Scenes for any list of shapes, so that they compile in a build that knows disks only, too.
namespace chesil::benchmark
{

constexpr std::uint64_t sceneSeed = 20240705;
/// Of the ratio of both builds.
constexpr int ratioGrains = 2000;
/// Radii [m], density [kg/m3], contact stiffness [N/m], Coulomb coefficient.
constexpr double smallestRadius = 0.008;
constexpr double largestRadius = 0.012;
constexpr double sceneDensity = 2650;
constexpr double sceneStiffness = 3e6;
constexpr double sceneFriction = 0.3;

/// `shapeOf(radius [m])` for some radii.
template <class ShapeOfRadius>
std::vector<NamedShape> shapesOfRadii(ShapeOfRadius shapeOf)
{
    constexpr int sizes = 20;
    std::vector<NamedShape> shapes;
    for (int i = 0; i < sizes; ++i)
    {
        const double radius = smallestRadius + (largestRadius - smallestRadius) * i / (sizes - 1);
        shapes.push_back({"grain" + std::to_string(i), shapeOf(radius)});
    }
    return shapes;
}

inline std::vector<NamedShape> diskShapes()
{
    return shapesOfRadii([](double radius) { return Circle(radius); });
}

/// Grains on a lattice in a box somewhat wider than high.
inline WorldSettings boxOf(std::vector<NamedShape> shapes, int grains)
{
    const double side = std::ceil(1.1 * std::sqrt(grains)) * 2.1 * largestRadius;
    WorldSettings settings;
    settings.shapes = std::move(shapes);
    settings.materials[0].density = sceneDensity;
    settings.linear().normalStiffness = sceneStiffness;
    settings.walls = {{"floor", Vector2::Zero(), Vector2::UnitY()},
                      {"left", Vector2::Zero(), Vector2::UnitX()},
                      {"right", Vector2(side, 0), -Vector2::UnitX()},
                      {"lid", Vector2(0, side), -Vector2::UnitY()}};
    std::vector<int> choice;
    for (std::size_t i = 0; i < settings.shapes.size(); ++i)
    {
        choice.push_back(static_cast<int>(i));
    }
    settings.grains =
        placeOnLattice(settings.shapes, choice, grains, {Vector2::Zero(), Vector2(side, side)}, sceneSeed);
    return settings;
}

/// A bed that settles under gravity.
inline WorldSettings bedOf(std::vector<NamedShape> shapes, int grains)
{
    WorldSettings settings = boxOf(std::move(shapes), grains);
    settings.gravity = Vector2(0, -9.81);
    settings.linear().tangentialStiffness = sceneStiffness;
    settings.linear().friction = sceneFriction;
    settings.linear().dampingRatio = 0.5;
    return settings;
}

/// A gas without gravity, friction and damping: few of the near pairs touch.
inline WorldSettings gasOf(std::vector<NamedShape> shapes, int grains)
{
    WorldSettings settings = boxOf(std::move(shapes), grains);
    test::RandomSource random(sceneSeed);
    for (GrainState& grain : settings.grains)
    {
        grain.velocity = random.uniform(0.1, 1) * random.direction();
    }
    return settings;
}

inline void runSteps(World& world, double timeStep, int steps)
{
    for (int step = 0; step < steps; ++step)
    {
        if (world.step(timeStep) != StepStatus::done)
        {
            throw std::runtime_error("a grain's motion is no longer finite");
        }
    }
}

} // namespace chesil::benchmark
