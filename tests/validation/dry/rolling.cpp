#include "validation/dry/report.hpp"
#include "validation/dry/scene.hpp"

namespace chesil::dry
{

/// A disk that rolls without slip at v, resisted by mu_r m g r: a = (2/3) mu_r g, so it stops after (3/4) v^2/(mu_r g) and
/// (3/2) v/(mu_r g). It yields only when the rolling spring is wound up, over a way of m g/(2.25 k mu_r): the error.
void rolling(Report& report)
{
    constexpr double radius = 0.01;
    constexpr double speed = 0.1;
    const auto distanceAt = [](double friction) { return 0.75 * speed * speed / (friction * gravity); };
    for (const double friction : {0.01, 0.02, 0.05, 0.1})
    {
        WorldSettings settings = linearScene(Circle(radius), 0.5, 0.5);
        settings.linear().normalStiffness = 1e7;
        settings.linear().tangentialStiffness = 1e7;
        settings.linear().rollingFriction = friction;
        settings.gravity = Vector2(0, -gravity);
        settings.walls = {floorWall()};
        const double weight = 2650 * M_PI * radius * radius * gravity;
        GrainState disk = grainAt(Vector2(0, radius - weight / 1e7), Vector2(speed, 0));
        disk.angularVelocity = -speed / radius;
        settings.grains = {disk};
        World world(settings);
        const double timeStep = 0.25 * world.stableTimeStep();
        while (world.bodies().velocity[0].x() > 0)
        {
            advance(world, timeStep);
        }
        const double distance = distanceAt(friction);
        const std::string tail = " mu_r " + std::to_string(friction).substr(0, 4);
        report.compare("rolling", "distance [m]" + tail, world.bodies().pose[0].position.x(), distance, 5e-4);
        report.compare("rolling", "time [s]" + tail, world.time(), 1.5 * speed / (friction * gravity), 5e-4);
        report.plot("Rolling to rest", "rolling friction", "distance [m]", "disk", friction, world.bodies().pose[0].position.x(), distance);
    }
    report.drawTheory("Rolling to rest", "disk", 0.01, 0.1, distanceAt);
}

} // namespace chesil::dry
