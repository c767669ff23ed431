/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "boundarySettings.H"
#include "checkedDictionary.H"
#include "contactSettings.H"

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

//- The walls that end a servo wall must cross it
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
                "point", "normal", "material", "velocity", "amplitude",
                "frequency", "pressure", "speed", "between"
            }
        );
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
        walls.push_back
        ({
            name,
            entries.planeVector("point"),
            normal.normalized(),
            materials.read(entries),
            readMotion(entries, names)
        });
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


// ************************************************************************* //
