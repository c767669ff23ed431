#pragma once

#include "core/contact/restitution.hpp"
#include "core/measure/energy.hpp"
#include "core/world/world.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <stdexcept>

/// Scenes that several cases share.
namespace chesil::dry
{

constexpr double gravity = 9.81;

/// Linear springs of 1 MN/m both ways, quartz; no grains, no walls, no gravity.
inline WorldSettings linearScene(const Shape& shape, double restitution, double friction)
{
    WorldSettings settings;
    settings.shapes = {{"grain", shape}};
    settings.materials[0].density = 2650;
    settings.linear().normalStiffness = 1e6;
    settings.linear().tangentialStiffness = friction > 0 ? 1e6 : 0;
    settings.linear().friction = friction;
    settings.linear().dampingRatio = dampingRatioOf(restitution);
    return settings;
}

inline GrainState grainAt(const Vector2& position, const Vector2& velocity = Vector2::Zero(), double angle = 0)
{
    GrainState grain;
    grain.position = position;
    grain.velocity = velocity;
    grain.angle = angle;
    return grain;
}

inline PlaneWall<2> floorWall() { return {"floor", Vector2::Zero(), Vector2::UnitY()}; }

/// One step; throws std::runtime_error if the world breaks.
inline void advance(World& world, double timeStep)
{
    const StepStatus status = world.step(timeStep);
    if (status != StepStatus::done)
    {
        throw std::runtime_error(describe(status, world.brokenGrain()));
    }
}

/// Until `end` [s].
inline void advanceTo(World& world, double end, double timeStep)
{
    while (world.time() < end - timeStep / 2)
    {
        advance(world, timeStep);
    }
}

inline double massOf(const World& world) { return world.settings().materials[0].density * world.areaOf(0); }

} // namespace chesil::dry
