#include "validation/dry/report.hpp"
#include "validation/dry/scene.hpp"

namespace chesil::dry
{

/// Nothing turns a free grain, and velocity Verlet is exact for a constant force: rounding alone is left, of 1e5 sums.
void freeMotion(Report& report)
{
    constexpr int steps = 100000;
    constexpr double timeStep = 1e-4;
    constexpr double rounding = steps * 2.2e-16;
    WorldSettings settings = linearScene(Ellipse(0.02, 0.01), 1, 0);
    GrainState grain = grainAt(Vector2(1, 2), Vector2(3, 4));
    grain.angularVelocity = 0.3;
    settings.grains = {grain};
    World spinning(settings);
    settings.gravity = Vector2(0, -gravity);
    World flying(settings);
    const double energy = kineticEnergy(spinning.bodies());
    flying.updateForces();
    for (int step = 0; step < steps; ++step)
    {
        advance(spinning, timeStep);
        advance(flying, timeStep);
    }
    const double end = steps * timeStep;
    const Rotation<2>& rotation = spinning.bodies().pose[0].rotation;
    report.compare("free", "angle after 1e5 steps, modulo 2 pi [rad]", std::remainder(rotation.angle() - 0.3 * end, 2 * M_PI), 0, rounding, 0.3 * end);
    report.compare("free", "energy after 1e5 steps [J]", kineticEnergy(spinning.bodies()), energy, 1e-15);
    report.compare("free", "height in flight [m]", flying.bodies().pose[0].position.y(), 2 + 4 * end - gravity / 2 * end * end, rounding);
    report.compare("free", "velocity in flight [m/s]", flying.bodies().velocity[0].y(), 4 - gravity * end, rounding);
}

} // namespace chesil::dry
