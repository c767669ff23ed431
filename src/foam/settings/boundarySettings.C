/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "boundarySettings.H"
#include "checkedDictionary.H"
#include "materialSettings.H"
#include "loadingSettings.H"

#include "core/boundary/plateWall.hpp"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::checkedDictionary;
using Foam::dictionary;

chesil::WallMotion readMotion
(
    const checkedDictionary& entries,
    const std::vector<Foam::word>& walls
)
{
    const bool driven =
        entries.found("velocity") || entries.found("amplitude")
     || entries.found("frequency");
    if (!entries.found("pressure"))
    {
        if (!driven)
        {
            return chesil::FixedWall{};
        }
        chesil::DrivenWall motion;
        if (entries.found("velocity"))
        {
            motion.velocity = entries.planeVector("velocity");
        }
        if (entries.found("amplitude") || entries.found("frequency"))
        {
            motion.amplitude = entries.planeVector("amplitude");
            motion.frequency = entries.positive("frequency");
        }
        return motion;
    }
    if (driven)
    {
        entries.fail
        (
            "pressure",
            "a law of motion, too",
            "either pressure, speed and between, or velocity, amplitude and"
            " frequency"
        );
    }
    chesil::ServoWall servo;
    servo.pressure = entries.notNegative("pressure", 0);
    servo.speed = entries.positive("speed");
    const std::vector<std::string> between = entries.words("between");
    const std::string expected = "the names of the two walls that end this one";
    if (between.size() != 2 || between[0] == between[1])
    {
        entries.fail
            ("between", std::to_string(between.size()) + " names", expected);
    }
    for (std::size_t k = 0; k < 2; ++k)
    {
        const auto found = std::find(walls.begin(), walls.end(), between[k]);
        if (found == walls.end())
        {
            entries.fail("between", between[k], expected);
        }
        servo.between[k] = std::size_t(found - walls.begin());
    }
    return servo;
}

chesil::PlaneWall<2> readEndlessWall
(
    const checkedDictionary& entries,
    const Foam::word& name
)
{
    const chesil::Vector2 normal = entries.planeVector("normal");
    if (!(normal.norm() > 0))
    {
        entries.fail
        (
            "normal",
            "a vector of no length",
            "the direction from the wall into the domain"
        );
    }
    chesil::PlaneWall<2> wall
        {name, entries.planeVector("point"), normal.normalized()};
    return wall;
}


chesil::PlaneWall<2> readPlate
(
    const checkedDictionary& entries,
    const Foam::word& name
)
{
    for (const char* foreign : {"point", "normal", "pressure", "speed", "between"})
    {
        if (entries.found(foreign))
        {
            entries.fail
            (
                foreign,
                "an entry of walls without end",
                "start, end and thickness, moved by velocity, amplitude and"
                " frequency if at all"
            );
        }
    }
    const chesil::Vector2 start = entries.planeVector("start");
    const chesil::Vector2 end = entries.planeVector("end");
    const double thickness =
        entries.found("thickness")
      ? entries.positive("thickness")
      : 1e-3*(end - start).norm();
    try
    {
        return chesil::plateWall(name, start, end, thickness);
    }
    catch (const chesil::ValueError& error)
    {
        throw error.at(entries.file(), entries.fullName("end"));
    }
}


//- The walls that end a servo wall must be endless and cross it
void checkServos
(
    const dictionary& dict,
    const std::vector<chesil::PlaneWall<2>>& walls
)
{
    for (const chesil::PlaneWall<2>& wall : walls)
    {
        const auto* servo = std::get_if<chesil::ServoWall>(&wall.motion);
        for (std::size_t k = 0; servo && k < 2; ++k)
        {
            const chesil::PlaneWall<2>& end = walls[servo->between[k]];
            if (end.plate)
            {
                checkedDictionary(dict.subDict(wall.name)).fail
                (
                    "between",
                    end.name + ", which has ends itself",
                    "two walls given by point and normal"
                );
            }
            if (std::abs(chesil::cross(wall.normal, end.normal)) < 0.1)
            {
                checkedDictionary(dict.subDict(wall.name)).fail
                (
                    "between",
                    end.name + ", which is parallel to this wall or nearly so",
                    "two walls that cross it"
                );
            }
        }
    }
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<chesil::PlaneWall<2>> Foam::readWalls
(
    const dictionary& dict,
    const materialSettings& materials
)
{
    std::vector<chesil::PlaneWall<2>> walls;
    const std::vector<word> names = checkedDictionary::subDictNames(dict);
    for (const word& name : names)
    {
        const checkedDictionary entries
        (
            dict.subDict(name),
            {
                "point", "normal", "start", "end", "thickness", "material",
                "velocity", "amplitude", "frequency", "pressure", "speed",
                "between"
            }
        );
        const bool ends =
            entries.found("start") || entries.found("end")
         || entries.found("thickness");
        chesil::PlaneWall<2> wall =
            ends ? readPlate(entries, name) : readEndlessWall(entries, name);
        wall.material = materials.read(entries);
        wall.motion = readMotion(entries, names);
        walls.push_back(wall);
    }
    checkServos(dict, walls);
    return walls;
}


chesil::StrainedCell Foam::readCell(const dictionary& dict)
{
    const checkedDictionary entries
        (dict, {"lower", "upper", "velocityGradient"});
    const chesil::Vector2 lower = entries.planeVector("lower");
    const chesil::Vector2 upper = entries.planeVector("upper");
    const chesil::Vector2 extent = upper - lower;
    if (!(extent.minCoeff() > 0 && extent.allFinite()))
    {
        entries.fail
        (
            "upper",
            '(' + chesil::numberText(upper.x()) + ' '
          + chesil::numberText(upper.y()) + " 0)",
            "a corner right of and above lower"
        );
    }
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
    if (entries.found("velocityGradient"))
    {
        const std::vector<double> found = entries.numbers("velocityGradient");
        if (found.size() != 4)
        {
            entries.fail
            (
                "velocityGradient",
                std::to_string(found.size()) + " numbers",
                "four, (xx xy yx yy): the change of vx along x, of vx along y,"
                " of vy along x, of vy along y"
            );
        }
        gradient << found[0], found[1], found[2], found[3];
    }
    return chesil::StrainedCell
    (
        chesil::PeriodicCell
        (
            lower,
            chesil::Vector2(extent.x(), 0),
            chesil::Vector2(0, extent.y())
        ),
        gradient
    );
}


void Foam::readBoundary
(
    const checkedDictionary& entries,
    const materialSettings& materials,
    chesil::WorldSettings& world
)
{
    const bool walls = entries.found("walls");
    const bool cell = entries.found("cell");
    if (entries.found("loading"))
    {
        if (walls || cell)
        {
            entries.fail
            (
                "loading",
                std::string(walls ? "walls" : "cell") + ", too",
                "loading alone: it makes the walls or the cell"
            );
        }
        readLoading(entries.subDict("loading"), materials, world);
        return;
    }
    if (walls)
    {
        world.walls = readWalls(entries.subDict("walls"), materials);
    }
    if (cell)
    {
        if (!world.walls.empty())
        {
            entries.fail
            (
                "cell", "walls, too", "one of both: a wall does not repeat itself"
            );
        }
        world.cell = readCell(entries.subDict("cell"));
    }
}


// ************************************************************************* //
