/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "grainSettings.H"
#include "checkedDictionary.H"
#include "compositionSettings.H"
#include "grainChecks.H"
#include "grainFileSettings.H"
#include "materialSettings.H"

#include "core/world/randomInsertion.hpp"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using chesil::GrainState;
using Foam::checkedDictionary;
using Foam::dictionary;
using Foam::shapeGroups;

std::uint64_t readSeed(const checkedDictionary& entries)
{
    return static_cast<std::uint64_t>(entries.count("seed", 0, 1));
}


//- Calls a function of core; what it refuses is the fault of the entry
template<class Function>
auto underEntry
(
    const checkedDictionary& entries,
    const Foam::word& name,
    const Function& function
)
{
    try
    {
        return function();
    }
    catch (const chesil::ValueError& error)
    {
        throw error.at(entries.file(), entries.fullName(name));
    }
}


std::vector<GrainState> readLattice(const dictionary& dict, shapeGroups& shapes)
{
    const checkedDictionary entries
    (
        dict,
        {
            "type", "number", "box", "shapes", "seed", "mixture", "sizes",
            "material"
        }
    );
    const chesil::PlacementBox box = Foam::readBox(entries);
    const Foam::label number = entries.count("number", 1);
    const std::uint64_t seed = readSeed(entries);
    if (!entries.found("mixture") && !entries.found("sizes"))
    {
        const std::vector<int> choice =
            Foam::readShapeNames(entries, "shapes", shapes);
        return underEntry(entries, "box", [&]
        {
            return chesil::placeOnLattice
                (shapes.shapes, choice, number, box, seed);
        });
    }
    const chesil::Composition composition =
        Foam::readComposition(entries, shapes);
    chesil::RandomEngine engine(seed);
    const std::vector<int> shapeOfGrain = underEntry(entries, "sizes", [&]
    {
        return chesil::composeNumber
            (shapes.shapes, composition, number, engine);
    });
    return underEntry(entries, "box", [&]
    {
        return chesil::placeOnLattice(shapes.shapes, shapeOfGrain, box, engine);
    });
}


std::vector<int> readRandomShapes
(
    const checkedDictionary& entries,
    const chesil::PlacementBox& box,
    shapeGroups& shapes,
    chesil::RandomEngine& engine
)
{
    const chesil::Composition composition =
        Foam::readComposition(entries, shapes);
    if (entries.found("number") == entries.found("solidFraction"))
    {
        entries.fail
        (
            "number",
            entries.found("number")
          ? "number and solidFraction" : "neither number nor solidFraction",
            "one of the two"
        );
    }
    if (entries.found("number"))
    {
        const Foam::label number = entries.count("number", 1);
        return underEntry(entries, "sizes", [&]
        {
            return chesil::composeNumber
                (shapes.shapes, composition, number, engine);
        });
    }
    const Foam::scalar fraction = entries.positive("solidFraction");
    if (fraction >= 1)
    {
        entries.fail
        (
            "solidFraction",
            chesil::numberText(fraction),
            "a share of the box's area, below 1"
        );
    }
    return underEntry(entries, "solidFraction", [&]
    {
        return chesil::composeArea
        (
            shapes.shapes,
            composition,
            fraction*(box.upper - box.lower).prod(),
            engine
        );
    });
}


std::vector<GrainState> readRandom(const dictionary& dict, shapeGroups& shapes)
{
    const checkedDictionary entries
    (
        dict,
        {
            "type", "number", "solidFraction", "box", "gap", "shapes", "seed",
            "mixture", "sizes", "material"
        }
    );
    const chesil::PlacementBox box = Foam::readBox(entries);
    const Foam::scalar gap = entries.notNegative("gap", 0);
    chesil::RandomEngine engine(readSeed(entries));
    underEntry(entries, "box", [&] { chesil::requireExtent(box); });
    const std::vector<int> shapeOfGrain =
        readRandomShapes(entries, box, shapes, engine);
    return underEntry(entries, "box", [&]
    {
        return chesil::insertAtRandom
            (shapes.shapes, shapeOfGrain, box, gap, engine);
    });
}


std::vector<GrainState> readSingle(const dictionary& dict, shapeGroups& shapes)
{
    const checkedDictionary entries
    (
        dict,
        {
            "type", "shape", "position", "angle", "velocity",
            "angularVelocity", "driven", "material"
        }
    );
    const std::string name = entries.text("shape");
    const auto& group = Foam::groupNamed(entries, "shape", name, shapes);
    if (group.size() != 1)
    {
        entries.fail
        (
            "shape",
            name + ", a group of " + std::to_string(group.size()) + " shapes",
            "the name of one shape"
        );
    }
    GrainState grain;
    grain.shape = group.front();
    grain.position = entries.planeVector("position");
    grain.angle = entries.number("angle", 0);
    if (entries.found("velocity"))
    {
        grain.velocity = entries.planeVector("velocity");
    }
    grain.angularVelocity = entries.number("angularVelocity", 0);
    grain.driven = entries.flag("driven", false);
    return {grain};
}


} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<chesil::GrainState> Foam::readGrains
(
    const dictionary& dict,
    shapeGroups& shapes,
    const chesil::WorldSettings& world,
    const materialSettings& materials,
    const fileName& caseFolder
)
{
    const std::map
    <
        std::string,
        std::vector<GrainState> (*)(const dictionary&, shapeGroups&)
    >
    readers
    {
        {"lattice", readLattice}, {"random", readRandom}, {"single", readSingle}
    };
    const checkedDictionary entries(dict);
    std::vector<GrainState> grains;
    for (const word& name : checkedDictionary::subDictNames(dict))
    {
        const dictionary& sub = dict.subDict(name);
        const std::string type =
            checkedDictionary(sub).choice
                ("type", {"file", "lattice", "random", "single"});
        std::vector<GrainState> some;
        if (type == "file")
        {
            some = readGrainFile(sub, shapes, materials, caseFolder);
        }
        else
        {
            some = readers.at(type)(sub, shapes);
            const int material = materials.read(checkedDictionary(sub));
            for (GrainState& grain : some)
            {
                grain.material = material;
            }
        }
        checkWalls(entries, name, some, shapes, world.walls);
        if (world.cell && sub.found("box"))
        {
            checkCell(checkedDictionary(sub), world.cell->cell);
        }
        grains.insert(grains.end(), some.begin(), some.end());
    }
    return grains;
}


// ************************************************************************* //
