#include "core/world/loading.hpp"

#include "core/base/setupError.hpp"

#include <cmath>

namespace chesil
{

namespace
{

enum Side : std::size_t
{
    left,
    right,
    floor,
    lid
};

std::vector<PlaneWall<2>> wallsAbout(const PlacementBox& box)
{
    requireExtent(box);
    const PlaneWall<2> atLeft{"left", box.lower, Vector2::UnitX()};
    const PlaneWall<2> atRight{"right", box.upper, -Vector2::UnitX()};
    const PlaneWall<2> below{"floor", box.lower, Vector2::UnitY()};
    const PlaneWall<2> above{"lid", box.upper, -Vector2::UnitY()};
    return {atLeft, atRight, below, above};
}

void requirePositive(const std::string& what, double value, const std::string& unit)
{
    if (!(value > 0 && std::isfinite(value)))
    {
        throw ValueError(what + " " + numberText(value), "a positive, finite one [" + unit + "]");
    }
}

ServoWall servo(double pressure, double speed, Side from, Side to)
{
    requirePositive("pressure", pressure, "Pa");
    requirePositive("speed", speed, "m/s");
    return {pressure, speed, {from, to}};
}

void requireFinite(const std::string& what, double value)
{
    if (!std::isfinite(value))
    {
        throw ValueError(what + " " + numberText(value), "a finite one [1/s]");
    }
}

} // namespace

std::vector<PlaneWall<2>> isotropicCompression(const PlacementBox& box, double pressure, double speed)
{
    std::vector<PlaneWall<2>> walls = wallsAbout(box);
    walls[left].motion = walls[right].motion = servo(pressure, speed, floor, lid);
    walls[floor].motion = walls[lid].motion = servo(pressure, speed, left, right);
    return walls;
}

std::vector<PlaneWall<2>> biaxialCompression(const PlacementBox& box, double confiningPressure,
                                             double servoSpeed, double axialStrainRate)
{
    requireFinite("strain rate", axialStrainRate);
    std::vector<PlaneWall<2>> walls = wallsAbout(box);
    walls[left].motion = walls[right].motion = servo(confiningPressure, servoSpeed, floor, lid);
    walls[floor].motion = ClosingWall{axialStrainRate, lid};
    walls[lid].motion = ClosingWall{axialStrainRate, floor};
    return walls;
}

StrainedCell simpleShear(const PlacementBox& box, double shearRate)
{
    requireExtent(box);
    requireFinite("shear rate", shearRate);
    const Vector2 extent = box.upper - box.lower;
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
    gradient(0, 1) = shearRate;
    return StrainedCell(PeriodicCell(box.lower, Vector2(extent.x(), 0), Vector2(0, extent.y())), gradient);
}

} // namespace chesil
