#include "validation/dry/report.hpp"
#include "validation/dry/scene.hpp"

namespace chesil::dry
{

namespace
{

constexpr double radius = 0.01;
constexpr double stiffness = 1e6;

/// n x n disks between floor and left wall and two servo walls at the given pressure: relative change of the height when
/// all is at rest.
double squareStrain(int number, double pressure)
{
    WorldSettings settings = linearScene(Circle(radius), 0.3, 0);
    const double length = 2 * radius * number;
    for (int i = 0; i < number * number; ++i)
    {
        settings.grains.push_back(grainAt(radius * Vector2(1 + 2 * (i % number), 1 + 2 * (i / number))));
    }
    const double speed = 0.01;
    settings.walls = {floorWall(), {"left", Vector2::Zero(), Vector2::UnitX()}, {"right", Vector2(length, 0), -Vector2::UnitX()}, {"lid", Vector2(0, length), -Vector2::UnitY()}};
    settings.walls[2].motion = ServoWall{pressure, speed, {0, 3}};
    settings.walls[3].motion = ServoWall{pressure, speed, {1, 2}};
    World world(settings);
    const double timeStep = 0.5 * world.stableTimeStep();
    advanceTo(world, 0.3, timeStep);
    return 1 - world.walls()[3].point.y() / length;
}

/// Disks of a triangular lattice in a periodic cell that shrinks evenly: mean of the normal stresses [Pa] from the
/// contacts and the strain of lengths e.
double trianglePressure(double& strain)
{
    WorldSettings settings = linearScene(Circle(radius), 1, 0);
    constexpr int number = 8;
    const Vector2 first(2 * radius, 0);
    const Vector2 second(radius, std::sqrt(3.0) * radius);
    settings.cell.emplace(PeriodicCell(Vector2::Zero(), number * first, number * second), -0.01 * Eigen::Matrix2d::Identity());
    for (int i = 0; i < number * number; ++i)
    {
        settings.grains.push_back(grainAt((i % number + 0.5) * first + (i / number + 0.5) * second));
    }
    World world(settings);
    const double area = cross(world.cell()->cell.first(), world.cell()->cell.second());
    advanceTo(world, 0.01, 0.25 * world.stableTimeStep());
    const double now = cross(world.cell()->cell.first(), world.cell()->cell.second());
    strain = 1 - std::sqrt(now / area);
    double sum = 0;
    for (const Contact<2>& contact : world.contacts())
    {
        sum -= contact.force.dot(world.branchOf(contact));
    }
    return sum / 2 / now;
}

} // namespace

/// Square, between walls: a row of n disks has n + 1 springs in series, n of them a length of 2 r n; so strain e takes
/// the pressure k n e/(n + 1) on the pressed length (1 - e). Triangular: sqrt(3) k e/(1 - e) from three contacts a
/// disk of length 2 r (1 - e), force 2 r k e, area 2 sqrt(3) r^2 (1 - e)^2. In the plane, bulk modulus k/2 and sqrt(3) k/2.
void lattice(Report& report)
{
    for (const int number : {2, 4, 8})
    {
        for (const double pressure : {1e3, 2e3, 4e3})
        {
            // (1 - e) p 2 r = k 2 r n e/(n + 1)
            const double compliance = pressure * (number + 1) / (stiffness * number);
            const double theory = compliance / (1 + compliance);
            const double found = squareStrain(number, pressure);
            const std::string size = std::to_string(number) + " x " + std::to_string(number);
            report.compare("lattice", "square " + size + " strain at [Pa] " + std::to_string(static_cast<int>(pressure)), found, theory, 1e-6);
            report.plot("Lattice between servo walls", "pressure [kPa]", "strain", size, pressure / 1000, found, theory);
        }
    }
    double strain = 0;
    const double pressure = trianglePressure(strain);
    report.compare("lattice", "triangular pressure [Pa] at a strain of 1e-4", pressure, std::sqrt(3.0) * stiffness * strain / (1 - strain), 1e-6);
}

} // namespace chesil::dry
