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
            "a name of the dictionary shapes: "
          + (known.empty() ? "it is empty" : chesil::listOfNames(known))
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
            entries.count("number", 1),
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

//- How far a grain reaches into a wall [m]; negative before it
Foam::scalar depthInWall
(
    const chesil::Shape& shape,
    const GrainState& grain,
    const chesil::PlaneWall<2>& wall
)
{
    const chesil::Pose<2> pose
        {grain.position, chesil::Rotation<2>(grain.angle)};
    const chesil::Vector2 foot = pose.toWorld
    (
        chesil::support(shape, pose.rotation.applyInverse(-wall.normal))
    );
    return -wall.distance(foot);
}

//- A grain that starts in a wall would be shot out of it
void checkWalls
(
    const checkedDictionary& entries,
    const Foam::word& name,
    const std::vector<GrainState>& grains,
    const shapeGroups& shapes,
    const std::vector<chesil::PlaneWall<2>>& walls
)
{
    constexpr Foam::scalar allowedShare = 0.1;
    for (const GrainState& grain : grains)
    {
        if (grain.driven)
        {
            continue;
        }
        const chesil::NamedShape& named =
            shapes.shapes[std::size_t(grain.shape)];
        for (const chesil::PlaneWall<2>& wall : walls)
        {
            const Foam::scalar depth = depthInWall(named.shape, grain, wall);
            if (depth > allowedShare*chesil::boundingRadius(named.shape))
            {
                entries.fail
                (
                    name,
                    "a grain " + named.name + " that reaches "
                  + chesil::numberText(depth) + " m into wall " + wall.name,
                    "grains that start between the walls: one bigger than"
                    " the box never fits"
                );
            }
        }
    }
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<chesil::GrainState> Foam::readGrains
(
    const dictionary& dict,
    const shapeGroups& shapes,
    const std::vector<chesil::PlaneWall<2>>& walls
)
{
    const checkedDictionary entries(dict);
    std::vector<GrainState> grains;
    for (const word& name : checkedDictionary::subDictNames(dict))
    {
        const dictionary& sub = dict.subDict(name);
        const std::string type =
            checkedDictionary(sub).choice("type", {"lattice", "single"});
        const auto some =
            type == "lattice" ? readLattice(sub, shapes) : readSingle(sub, shapes);
        checkWalls(entries, name, some, shapes, walls);
        grains.insert(grains.end(), some.begin(), some.end());
    }
    return grains;
}


// ************************************************************************* //
