#include "validation/dry/report.hpp"
#include "validation/dry/scene.hpp"

namespace chesil::dry
{

namespace
{

struct Sweep
{
    bool hertz;
    bool wall;
    NamedShape shape;
};

void useHertz(WorldSettings& settings, double restitution, double friction)
{
    LawTable<HertzMindlinLaw> laws;
    const ElasticMaterial soft{1e7, 0.25};
    laws.only().effectiveModulus = effectiveModulusOf(soft, soft);
    laws.only().effectiveShearModulus = effectiveShearModulusOf(soft, soft);
    laws.only().friction = friction;
    laws.only().dampingRatio = dampingRatioOf(restitution);
    settings.contact = laws;
}

/// A grain flies at a wall, or at its own image turned by half a turn, that it touches; the energy afterwards
/// over that before, less 1.
double gainOf(const Sweep& sweep, double degrees, double restitution, double friction, double share)
{
    constexpr double speed = 0.05;
    constexpr double tilt = 0.5;
    const double angle = degrees * M_PI / 180;
    WorldSettings settings = linearScene(sweep.shape.shape, restitution, friction);
    if (sweep.hertz)
    {
        useHertz(settings, restitution, friction);
    }
    const Rotation<2> rotation(tilt);
    const Vector2 lowest = rotation.apply(support(sweep.shape.shape, rotation.applyInverse(-Vector2::UnitY())));
    const Vector2 velocity = speed * Vector2(std::sin(angle), -std::cos(angle));
    settings.grains = {grainAt(-lowest, velocity, tilt)};
    if (sweep.wall)
    {
        settings.walls = {floorWall()};
    }
    else
    {
        settings.grains.push_back(grainAt(lowest, Vector2::Zero(), tilt + M_PI));
    }
    World world(settings);
    const double before = kineticEnergy(world.bodies());
    world.updateForces();
    const double timeStep = share * world.stableTimeStep();
    advanceTo(world, sweep.hertz ? 0.04 : 0.008, timeStep);
    return (kineticEnergy(world.bodies()) + world.contactEnergy()) / before - 1;
}

/// Over angles, frictions and both restitutions.
double largestGain(const Sweep& sweep, double share)
{
    double largest = -1;
    for (int degrees = 0; degrees <= 90; degrees += 5)
    {
        for (const double friction : {0.0, 0.1, 0.3, 1.0})
        {
            for (const double restitution : {1.0, 0.8})
            {
                largest = std::max(largest, gainOf(sweep, degrees, restitution, friction, share));
            }
        }
    }
    return largest;
}

} // namespace

void grazing(Report& report)
{
    test::RandomSource random(11);
    test::RandomGrainOptions pebble;
    pebble.radius = 0.01;
    const std::vector<NamedShape> shapes{{"disk", Circle(0.01)}, {"ellipse", Ellipse(0.014, 0.008)}, {"polybezier", randomPolyBezier(pebble, random)}};
    for (const bool hertz : {false, true})
    {
        for (const bool wall : {true, false})
        {
            for (const NamedShape& shape : shapes)
            {
                const std::string name = std::string(hertz ? "Hertz " : "linear ") + shape.name + (wall ? " on wall" : " on grain");
                double first = 0;
                double gain = 0;
                for (const int finer : {1, 4, 16})
                {
                    gain = largestGain({hertz, wall, shape}, 0.2 / finer);
                    first = finer == 1 ? gain : first;
                    // The line falls as the square of the step from the first point.
                    report.plot("Largest gain in grazing impacts", "time step over stable step", "E after/E before - 1", name, 0.2 / finer, gain, first / (finer * finer));
                }
                report.compare("grazing", "largest gain " + name, std::max(0.0, gain), 0, 1e-5, 1);
            }
        }
    }
}

} // namespace chesil::dry
