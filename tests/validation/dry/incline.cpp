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
    /// Mean over the second half of the time [m/s2].
    double acceleration;
    double way;
};

/// A square block on a floor under gravity tilted by the angle, 0.2 s.
Slide slideAt(double angle)
{
    WorldSettings settings = linearScene(test::rectangle(side, side), 0.5, friction);
    settings.walls = {floorWall()};
    settings.gravity = gravity * Vector2(std::sin(angle), -std::cos(angle));
    settings.grains = {grainAt(Vector2(0, side / 2))};
    World world(settings);
    const double timeStep = 0.25 * world.stableTimeStep();
    advanceTo(world, 0.1, timeStep);
    const double begin = world.time();
    const double speed = world.bodies().velocity[0].x();
    const double place = world.bodies().pose[0].position.x();
    advanceTo(world, 0.2, timeStep);
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
        report.compare("incline", "acceleration over g" + tail, found.acceleration / gravity, theoryAt(angle) / gravity, 1e-4, 1);
    }
    for (int degrees = 0; degrees <= 50; degrees += 5)
    {
        const double angle = degrees * M_PI / 180;
        report.plot("Block on an incline", "angle [deg]", "acceleration over g", "square block", degrees, slideAt(angle).acceleration / gravity, theoryAt(angle) / gravity);
    }
}

} // namespace chesil::dry
