#include "validation/dry/report.hpp"
#include "validation/dry/scene.hpp"

namespace chesil::dry
{

namespace
{

constexpr double friction = 0.5;
constexpr double side = 0.02;

struct Slide
{
    /// Mean over the last 0.1 s [m/s2].
    double acceleration;
    double way;
};

/// A square block at rest on a floor; its weight is tilted to the angle within 0.1 s and held, slow beside the contact's period of
/// 5 ms, so that no jolt makes it slip.
Slide slideAt(double angle)
{
    WorldSettings settings = linearScene(test::rectangle(side, side), 0.5, friction);
    settings.walls = {floorWall()};
    const double weight = 2650 * side * side * gravity;
    // Both ends of its lower side bear half the weight.
    settings.grains = {grainAt(Vector2(0, side / 2 - weight / 2 / 1e6))};
    World world(settings);
    const double timeStep = 0.25 * world.stableTimeStep();
    for (double share = 0; share < 1;)
    {
        share = std::min(1.0, world.time() / 0.1);
        const double tilt = angle * share * share * (3 - 2 * share);
        world.setExternalLoads({weight * Vector2(std::sin(tilt), -std::cos(tilt))}, {0.0});
        advance(world, timeStep);
    }
    advanceTo(world, 0.15, timeStep);
    const double begin = world.time();
    const double speed = world.bodies().velocity[0].x();
    const double place = world.bodies().pose[0].position.x();
    advanceTo(world, 0.25, timeStep);
    return {(world.bodies().velocity[0].x() - speed) / (world.time() - begin), world.bodies().pose[0].position.x() - place};
}

} // namespace

/// Sticks below the friction angle arctan(mu), slides at g (sin - mu cos) above it.
void incline(Report& report)
{
    const double limit = std::atan(friction) * 180 / M_PI;
    const auto theoryAt = [](double angle) { return std::max(0.0, gravity * (std::sin(angle) - friction * std::cos(angle))); };
    for (const double offset : {-0.1, 0.1, 1.0, 5.0, 15.0})
    {
        const double angle = (limit + offset) * M_PI / 180;
        const Slide found = slideAt(angle);
        const std::string tail = " at friction angle " + std::to_string(offset).substr(0, 4) + " deg";
        if (offset < 0)
        {
            report.compare("incline", "creep over side in 0.1 s" + tail, found.way / side, 0, 1e-6, 1);
        }
        report.compare("incline", "acceleration over g" + tail, found.acceleration / gravity, theoryAt(angle) / gravity, 1e-6, 1);
    }
    for (int degrees = 0; degrees <= 50; degrees += 5)
    {
        const double angle = degrees * M_PI / 180;
        report.plot("Block on an incline", "angle [deg]", "acceleration over g", "square block", degrees, slideAt(angle).acceleration / gravity, theoryAt(angle) / gravity);
    }
    report.drawTheory("Block on an incline", "square block", 0, 50, [&](double degrees) { return theoryAt(degrees * M_PI / 180) / gravity; });
}

} // namespace chesil::dry
