/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "loadingSettings.H"
#include "checkedDictionary.H"
#include "materialSettings.H"

#include "core/world/loading.hpp"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::checkedDictionary;
using Foam::dictionary;

const std::map<std::string, std::vector<std::string>> namesOfType
{
    {
        "isotropic",
        {"type", "lower", "upper", "pressure", "speed", "material"}
    },
    {
        "biaxial",
        {
            "type", "lower", "upper", "pressure", "speed", "strainRate",
            "material"
        }
    },
    {"simpleShear", {"type", "lower", "upper", "strainRate"}}
};

chesil::PlacementBox readSample(const checkedDictionary& entries)
{
    const chesil::PlacementBox box
        {entries.planeVector("lower"), entries.planeVector("upper")};
    try
    {
        chesil::requireExtent(box);
    }
    catch (const chesil::ValueError& error)
    {
        throw error.at(entries.file(), entries.fullName("upper"));
    }
    return box;
}


//- Walls that give way carry no weight: all would fall for ever
void checkGravity
(
    const checkedDictionary& entries,
    const std::string& type,
    const chesil::Vector2& gravity
)
{
    const bool biaxial = type == "biaxial";
    if (gravity.x() == 0 && (biaxial || gravity.y() == 0))
    {
        return;
    }
    entries.fail
    (
        "type",
        type + " and gravity (" + chesil::numberText(gravity.x()) + ' '
      + chesil::numberText(gravity.y()) + " 0)",
        biaxial
      ? "no gravity in x: left and right give way to it"
      : "gravity (0 0 0): all walls give way to it"
    );
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::readLoading
(
    const dictionary& dict,
    const materialSettings& materials,
    chesil::WorldSettings& world
)
{
    const std::string type = checkedDictionary(dict).choice
        ("type", {"isotropic", "biaxial", "simpleShear"});
    const checkedDictionary entries(dict, namesOfType.at(type));
    const chesil::PlacementBox box = readSample(entries);
    const auto strainRate = [&]
    {
        return entries.numberIn
            ("strainRate", -VGREAT, VGREAT, "a finite number");
    };
    if (type == "simpleShear")
    {
        world.cell = chesil::simpleShear(box, strainRate());
        return;
    }
    checkGravity(entries, type, world.gravity);
    const scalar pressure = entries.positive("pressure");
    const scalar speed = entries.positive("speed");
    world.walls =
        type == "isotropic"
      ? chesil::isotropicCompression(box, pressure, speed)
      : chesil::biaxialCompression(box, pressure, speed, strainRate());
    const int material = materials.read(entries);
    for (chesil::PlaneWall<2>& wall : world.walls)
    {
        wall.material = material;
    }
}


// ************************************************************************* //
