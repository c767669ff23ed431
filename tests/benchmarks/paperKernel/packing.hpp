#pragma once

#include "core/io/templateFile.hpp"
#include "core/io/worldGrainTable.hpp"
#include "core/measure/energy.hpp"
#include "core/world/world.hpp"

#include <iterator>
#include <stdexcept>

namespace chesil::benchmark
{

/// Of Lai & Huang, section 5.2, as tutorials/dry/randomPacking/case has it [s].
constexpr double timeStep = 1e-4;

/// The packing that tutorials/dry/randomPacking leaves: its table of grains, and the template files of their shapes.
struct PackingFiles
{
    std::string grains;
    std::vector<std::string> templates;
};

/// With the box and the contacts of that case.
inline WorldSettings packingSettings(const PackingFiles& files)
{
    constexpr double width = 1;
    WorldSettings settings;
    settings.materials[0] = {"material", 2650};
    settings.gravity = Vector2(0, -9.81);
    settings.linear().normalStiffness = 1e7;
    settings.linear().tangentialStiffness = 1e7;
    settings.linear().friction = 0.2;
    settings.localDamping = 0.7;
    settings.walls = {{"floor", Vector2::Zero(), Vector2::UnitY()},
                      {"left", Vector2::Zero(), Vector2::UnitX()},
                      {"right", Vector2(width, 0), -Vector2::UnitX()}};
    for (const std::string& path : files.templates)
    {
        std::vector<NamedShape> shapes = readTemplates(path).grains;
        std::move(shapes.begin(), shapes.end(), std::back_inserter(settings.shapes));
    }
    settings.grains = placeGrains(files.grains, readGrainTable(files.grains), settings.shapes, settings.materials);
    return settings;
}

/// Two placed grains whose bounding circles overlap, now and a time step before.
struct NearPair
{
    const Shape* a;
    const Shape* b;
    Pose<2> poseA;
    Pose<2> poseB;
    Pose<2> beforeA;
    Pose<2> beforeB;
    double size() const { return boundingRadius(*a) + boundingRadius(*b); }
};

/// One more step, and the pairs near each other after it.
inline std::vector<NearPair> nearPairs(World& world)
{
    const std::vector<Pose<2>> before = world.bodies().pose;
    world.updateForces();
    if (world.step(timeStep) != StepStatus::done)
    {
        throw std::runtime_error("paperKernel: the packing cannot be stepped on");
    }
    const std::vector<Pose<2>>& now = world.bodies().pose;
    std::vector<NearPair> pairs;
    for (const Contact<2>& contact : world.contacts())
    {
        if (contact.withWall())
        {
            continue;
        }
        const std::size_t i = static_cast<std::size_t>(contact.first);
        const std::size_t j = static_cast<std::size_t>(contact.second);
        const NearPair pair{&world.shapeOf(i), &world.shapeOf(j), now[i], now[j], before[i], before[j]};
        if ((now[j].position - now[i].position).norm() <= pair.size())
        {
            pairs.push_back(pair);
        }
    }
    return pairs;
}

} // namespace chesil::benchmark
