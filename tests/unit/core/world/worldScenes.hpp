#pragma once

#include "core/world/placement.hpp"
#include "core/world/world.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <cstdint>
#include <cstring>

/// Scenes that several tests of the world run.
namespace chesil::test
{

/// One of each kind of shape, about 0.05 m wide.
inline std::vector<NamedShape> shapesOfEachKind(std::uint64_t seed)
{
    RandomSource random(seed);
    RandomGrainOptions pebble;
    pebble.radius = 0.025;
    pebble.straight = 1;
    return {
        {"ball", Circle(0.025)},
        {"egg", Ellipse(0.03, 0.02)},
        {"tile", randomPolygon(5, 0.025, random)},
        {"pebble", randomPolyBezier(pebble, random)},
    };
}

/// No grains, no walls; quartz, gravity, friction, local damping as in the paper's packing.
inline WorldSettings quartzSettings()
{
    WorldSettings settings;
    settings.materials[0].density = 2650;
    settings.gravity = Vector2(0, -9.81);
    settings.linear().normalStiffness = 1e6;
    settings.linear().tangentialStiffness = 1e6;
    settings.linear().friction = 0.3;
    settings.localDamping = 0.7;
    return settings;
}

/// One ball of radius 0.05 m in free space, nothing damped.
inline WorldSettings freeBall()
{
    WorldSettings settings = quartzSettings();
    settings.gravity = Vector2::Zero();
    settings.localDamping = 0;
    settings.shapes = {{"ball", Circle(0.05)}};
    settings.grains = {GrainState{}};
    return settings;
}

inline PlaneWall<2> floorWall() { return {"floor", Vector2(0, 0), Vector2(0, 1)}; }

/// `number` grains of all kinds on a lattice above a box 0.6 m wide.
inline WorldSettings mixedScene(int number, std::uint64_t seed)
{
    WorldSettings settings = quartzSettings();
    settings.shapes = shapesOfEachKind(seed);
    settings.grains =
        placeOnLattice(settings.shapes, {0, 1, 2, 3}, number, {Vector2(0, 0), Vector2(0.6, 2)}, seed);
    settings.walls = {
        floorWall(), {"left", Vector2(0, 0), Vector2(1, 0)}, {"right", Vector2(0.6, 0), Vector2(-1, 0)}};
    return settings;
}

/// FNV-1a over the bits of all poses and velocities.
inline std::uint64_t hashOf(const World& world)
{
    std::uint64_t hash = 14695981039346656037u;
    const auto mix = [&hash](double value)
    {
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        for (int i = 0; i < 8; ++i)
        {
            hash = (hash ^ (bits >> (8 * i) & 0xff)) * 1099511628211u;
        }
    };
    const Bodies<2>& bodies = world.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        mix(bodies.pose[i].position.x());
        mix(bodies.pose[i].position.y());
        mix(bodies.pose[i].rotation.angle());
        mix(bodies.velocity[i].x());
        mix(bodies.velocity[i].y());
        mix(bodies.angularVelocity[i]);
    }
    return hash;
}

} // namespace chesil::test
