/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "worldSettingsReader.H"
#include "checkedDictionary.H"
#include "grainSettings.H"
#include "shapeSettings.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::checkedDictionary;
using Foam::dictionary;
using Foam::scalar;

const std::vector<std::string> knownNames
{
    "gravity", "material", "contact", "damping", "walls", "shapes", "grains",
    "timeStep", "stopAtRest", "fluid"
};

chesil::LinearLaw readContact(const dictionary& dict)
{
    const checkedDictionary entries
    (
        dict,
        {"normalStiffness", "tangentialStiffness", "friction", "restitution"}
    );
    chesil::LinearLaw law;
    law.normalStiffness = entries.positive("normalStiffness");
    law.tangentialStiffness =
        entries.notNegative("tangentialStiffness", law.normalStiffness);
    law.friction = entries.notNegative("friction", 0);
    if (entries.found("restitution"))
    {
        law.dampingRatio = chesil::dampingRatioOf
        (
            entries.numberIn("restitution", 1e-3, 1, "a number in [0.001, 1]")
        );
    }
    return law;
}

std::vector<chesil::PlaneWall<2>> readWalls(const dictionary& dict)
{
    std::vector<chesil::PlaneWall<2>> walls;
    for (const Foam::word& name : checkedDictionary::subDictNames(dict))
    {
        const checkedDictionary entries(dict.subDict(name), {"point", "normal"});
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
            ({name, entries.planeVector("point"), normal.normalized()});
    }
    return walls;
}

//- A grain that starts in a wall would be shot out of it
void checkWalls(const checkedDictionary& entries, const chesil::WorldSettings& world)
{
    constexpr scalar allowedShare = 0.1;
    for (std::size_t i = 0; i < world.grains.size(); ++i)
    {
        const chesil::GrainState& grain = world.grains[i];
        const auto& shape = world.shapes[std::size_t(grain.shape)].shape;
        const chesil::Pose<2> pose
            {grain.position, chesil::Rotation<2>(grain.angle)};
        for (const chesil::PlaneWall<2>& wall : world.walls)
        {
            const chesil::Vector2 foot = pose.toWorld
            (
                chesil::support(shape, pose.rotation.applyInverse(-wall.normal))
            );
            const scalar depth = -wall.distance(foot);
            if (depth > allowedShare*chesil::boundingRadius(shape))
            {
                entries.fail
                (
                    "grains",
                    "grain " + std::to_string(i) + " "
                  + chesil::numberText(depth) + " m inside wall " + wall.name,
                    "grains that start inside the walls: one bigger than the"
                    " box never fits"
                );
            }
        }
    }
}

Foam::runSettings readRun(const checkedDictionary& entries)
{
    Foam::runSettings run;
    if (entries.found("timeStep"))
    {
        const checkedDictionary step
            (entries.subDict("timeStep"), {"allowUnstable", "share"});
        run.allowUnstable = step.flag("allowUnstable", false);
        if (step.found("share"))
        {
            run.shareOfStable =
                step.numberIn("share", 1e-6, 1, "a number in [1e-6, 1]");
        }
    }
    run.stopAtRest = entries.notNegative("stopAtRest", 0);
    return run;
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::IOdictionary> Foam::chesilProperties(const Time& runTime)
{
    IOobject header
    (
        "chesilProperties",
        runTime.constant(),
        runTime,
        IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
    if (!header.typeHeaderOk<IOdictionary>(false))
    {
        throw chesil::SetupError
        (
            runTime.constant() + "/chesilProperties",
            "(whole file)",
            "no readable dictionary",
            "the grains' properties, with a FoamFile header"
        );
    }
    return autoPtr<IOdictionary>(new IOdictionary(header));
}


Foam::fluidSettings Foam::readFluid(const dictionary& properties)
{
    const checkedDictionary fluid
        (checkedDictionary(properties, knownNames).subDict("fluid"), {"density"});
    fluidSettings result;
    result.density = fluid.positive("density");
    return result;
}


Foam::caseSettings Foam::readCase
(
    const dictionary& properties,
    const Time& runTime
)
{
    const checkedDictionary entries(properties, knownNames);

    caseSettings result;
    chesil::WorldSettings& world = result.world;
    world.gravity = entries.planeVector("gravity");
    world.density =
        checkedDictionary(entries.subDict("material"), {"density"})
       .positive("density");
    world.contact = readContact(entries.subDict("contact"));
    if (entries.found("damping"))
    {
        const checkedDictionary damping(entries.subDict("damping"), {"local"});
        world.localDamping =
            damping.numberIn("local", 0, 1 - SMALL, "a number in [0, 1)");
    }
    if (entries.found("walls"))
    {
        world.walls = readWalls(entries.subDict("walls"));
    }
    const shapeGroups shapes =
        readShapes(entries.subDict("shapes"), runTime.globalPath());
    world.shapes = shapes.shapes;
    world.grains = readGrains(entries.subDict("grains"), shapes);
    checkWalls(entries, world);
    result.run = readRun(entries);
    return result;
}


// ************************************************************************* //
