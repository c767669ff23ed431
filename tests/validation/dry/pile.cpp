#include "validation/dry/report.hpp"
#include "validation/dry/scene.hpp"

namespace chesil::dry
{

namespace
{

constexpr double radius = 0.01;

struct PileForces
{
    /// Over the weight of a disk: of the upper on a lower one, along the normal and across it; of the floor, of a wall.
    double normal, tangential, floor, wall;
    /// Of the line of the lower centre to the upper one against the vertical, as it ends up [rad].
    double angle;
};

/// Two disks on the floor, a gap apart, and one on top; rests.
PileForces forcesOf(double gap, double friction, bool walls)
{
    WorldSettings settings = linearScene(Circle(radius), 0.2, friction);
    settings.linear().normalStiffness = 1e7;
    settings.linear().tangentialStiffness = friction > 0 ? 1e7 : 0;
    settings.gravity = Vector2(0, -gravity);
    const double aside = radius + gap / 2;
    settings.walls = {floorWall()};
    if (walls)
    {
        settings.walls.push_back({"left", Vector2(-aside - radius, 0), Vector2::UnitX()});
        settings.walls.push_back({"right", Vector2(aside + radius, 0), -Vector2::UnitX()});
    }
    const double up = std::sqrt(4 * radius * radius - aside * aside);
    settings.grains = {grainAt(Vector2(-aside, radius)), grainAt(Vector2(aside, radius)), grainAt(Vector2(0, radius + up))};
    World world(settings);
    advanceTo(world, 1.0, 0.5 * world.stableTimeStep());
    PileForces found{};
    const double weight = massOf(world) * gravity;
    for (const Contact<2>& contact : world.contacts())
    {
        if (contact.first == 0 && contact.second == 2)
        {
            const double along = contact.force.dot(contact.normal);
            found.normal = -along / weight;
            found.tangential = (contact.force - along * contact.normal).norm() / weight;
            found.angle = std::atan2(contact.normal.x(), contact.normal.y());
        }
    }
    found.floor = world.wallStates()[0].force.norm() / weight;
    found.wall = walls ? std::abs(world.wallStates()[1].force.x()) / weight : 0;
    return found;
}

double smoothWall(double angle) { return std::tan(angle) / 2; }
double smoothNormal(double angle) { return 0.5 / std::cos(angle); }
double roughTangential(double angle) { return std::tan(angle / 2) / 2; }

} // namespace

/// With a the angle of a line of centres against the vertical and the weight W of a disk. Smooth, between walls:
/// N = W/(2 cos a), wall W tan(a)/2. Rough, on the floor alone: torque balance makes both tangential forces of a lower disk
/// alike, T; forces then give N = W/2 and T = W tan(a/2)/2. Either way the floor bears 3 W.
void pile(Report& report)
{
    for (const double gap : {0.1, 0.3, 0.6})
    {
        const std::string tail = " gap over r " + std::to_string(gap).substr(0, 3);
        const PileForces smooth = forcesOf(gap * radius, 0, true);
        report.compare("pile", "smooth N/W" + tail, smooth.normal, smoothNormal(smooth.angle), 1e-9);
        report.compare("pile", "smooth wall/W" + tail, smooth.wall, smoothWall(smooth.angle), 1e-9);
        report.compare("pile", "smooth floor/W" + tail, smooth.floor, 3, 1e-9);
        const PileForces rough = forcesOf(gap * radius, 0.5, false);
        report.compare("pile", "rough N/W" + tail, rough.normal, 0.5, 1e-4);
        report.compare("pile", "rough T/W" + tail, rough.tangential, roughTangential(rough.angle), 1e-4);
        report.compare("pile", "rough floor/W" + tail, rough.floor, 3, 1e-4);
        report.plot("Pile of three", "gap over radius", "force over weight (T: rough)", "wall", gap, smooth.wall, smoothWall(smooth.angle));
        report.plot("Pile of three", "gap over radius", "force over weight (T: rough)", "N", gap, smooth.normal, smoothNormal(smooth.angle));
        report.plot("Pile of three", "gap over radius", "force over weight (T: rough)", "T", gap, rough.tangential, roughTangential(rough.angle));
    }
    for (const auto& [series, theory] : {std::pair("wall", smoothWall), std::pair("N", smoothNormal), std::pair("T", roughTangential)})
    {
        report.drawTheory("Pile of three", series, 0.1, 0.6, [force = theory](double gap) { return force(std::asin((1 + gap / 2) / 2)); });
    }
}

} // namespace chesil::dry
