/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "grainSettings.H"
#include "checkedDictionary.H"

#include "core/world/placement.hpp"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using chesil::GrainState;
using Foam::checkedDictionary;
using Foam::dictionary;
using Foam::shapeGroups;

const std::vector<int>& groupNamed
(
    const checkedDictionary& entries,
    const Foam::word& entryName,
    const std::string& name,
    const shapeGroups& shapes
)
{
    const auto group = shapes.groups.find(name);
    if (group == shapes.groups.end())
    {
        std::vector<std::string> known;
        for (const auto& g : shapes.groups)
        {
            known.push_back(g.first);
        }
        entries.fail
        (
            entryName,
            name,
            "a name of the dictionary shapes: " + chesil::listOfNames(known)
        );
    }
    return group->second;
}

std::vector<GrainState> readLattice
(
    const dictionary& dict,
    const shapeGroups& shapes
)
{
    const checkedDictionary entries
        (dict, {"type", "number", "box", "shapes", "seed"});
    std::vector<int> choice;
    for (const std::string& name : entries.words("shapes"))
    {
        const auto& group = groupNamed(entries, "shapes", name, shapes);
        choice.insert(choice.end(), group.begin(), group.end());
    }
    if (choice.empty())
    {
        entries.fail("shapes", "no shape", "at least one");
    }
    const checkedDictionary box(entries.subDict("box"), {"lower", "upper"});
    try
    {
        return chesil::placeOnLattice
        (
            shapes.shapes,
            choice,
            entries.count("number", 0),
            {box.planeVector("lower"), box.planeVector("upper")},
            static_cast<std::uint64_t>(entries.count("seed", 0, 1))
        );
    }
    catch (const chesil::ValueError& error)
    {
        throw error.at(entries.file(), entries.fullName("box"));
    }
}

std::vector<GrainState> readSingle
(
    const dictionary& dict,
    const shapeGroups& shapes
)
{
    const checkedDictionary entries
    (
        dict,
        {
            "type", "shape", "position", "angle", "velocity",
            "angularVelocity", "driven"
        }
    );
    const std::string name = entries.text("shape");
    const auto& group = groupNamed(entries, "shape", name, shapes);
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
    const shapeGroups& shapes
)
{
    std::vector<GrainState> grains;
    for (const word& name : checkedDictionary::subDictNames(dict))
    {
        const dictionary& sub = dict.subDict(name);
        const std::string type =
            checkedDictionary(sub).choice("type", {"lattice", "single"});
        const auto some =
            type == "lattice" ? readLattice(sub, shapes) : readSingle(sub, shapes);
        grains.insert(grains.end(), some.begin(), some.end());
    }
    return grains;
}


// ************************************************************************* //
