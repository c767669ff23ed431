/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "worldSettingsReader.H"
#include "boundarySettings.H"
#include "checkedDictionary.H"
#include "contactSettings.H"
#include "materialSettings.H"
#include "grainSettings.H"
#include "readingGuards.H"
#include "shapeSettings.H"

#include "IFstream.H"
#include "OSspecific.H"

#include "core/world/namedMeasures.hpp"
#include "core/world/world.hpp"

#include <algorithm>
#include <utility>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::checkedDictionary;
using Foam::dictionary;
using Foam::scalar;

const std::vector<std::string> knownNames
{
    "gravity", "material", "materials", "contact", "damping", "walls", "cell",
    "loading", "shapes", "grains", "timeStep", "stopAtRest", "contactStatistics",
    "measures", "checkpoints", "forceChains", "statesEvery", "fluid", "variables"
};

//- Grains that start inside each other would be shot apart; driven ones stay
void checkOverlaps
(
    const checkedDictionary& entries,
    const chesil::WorldSettings& settings
)
{
    constexpr scalar allowedShare = 0.1;
    chesil::World world(settings);
    try
    {
        world.updateForces();
    }
    catch (const chesil::ValueError& error)
    {
        // Nothing but a cell refuses: for grains too wide or far off
        const Foam::word cell = entries.found("cell") ? "cell" : "loading";
        throw error.at(entries.file(), entries.fullName(cell));
    }
    for (const chesil::Contact<2>& contact : world.contacts())
    {
        if (contact.withWall())
        {
            continue;
        }
        const auto i = std::size_t(contact.first);
        const auto j = std::size_t(contact.second);
        const bool bothDriven =
            settings.grains[i].driven && settings.grains[j].driven;
        const scalar smaller = std::min(world.sizeOf(i), world.sizeOf(j));
        if (!bothDriven && contact.depth > allowedShare*smaller)
        {
            entries.fail
            (
                "grains",
                "grains " + std::to_string(i) + " and " + std::to_string(j)
              + " (counted from 0) that overlap by "
              + chesil::numberText(contact.depth) + " m",
                "grains that start beside each other"
            );
        }
    }
}

//- Reads the file for itself: IOdictionary resets OpenFOAM's ways with names
void checkNames(const Foam::fileName& path)
{
    const Foam::throwingErrors errors;
    const Foam::uniqueNames names;
    try
    {
        Foam::IFstream file(path);
        dictionary contents;
        contents.name() = path;
        contents.read(file);
    }
    catch (const Foam::error& error)
    {
        const auto* inFile = dynamic_cast<const Foam::IOerror*>(&error);
        const std::string found = error.message();
        const bool twice = found.find("duplicate entry") == 0;
        throw chesil::SetupError
        (
            checkedDictionary::shownFile(path),
            inFile
          ? "line " + std::to_string(inFile->ioStartLineNumber())
          : "(whole file)",
            found.substr(0, found.find_last_not_of(" \n") + 1),
            twice
          ? "each name once (#overwrite before the second replaces the first)"
          : "a dictionary in OpenFOAM's format"
        );
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
    run.checkpoints = entries.flag("checkpoints", true);
    run.forceChains = entries.flag("forceChains", false);
    run.statesEvery = entries.count("statesEvery", 1, 1);
    run.stopAtRest = entries.notNegative("stopAtRest", 0);
    if (entries.found("measures"))
    {
        const std::vector<std::string> known = chesil::measureNames();
        run.measures = entries.words("measures");
        for (const std::string& name : run.measures)
        {
            if
            (
                std::count(known.begin(), known.end(), name) == 0
             || std::count(run.measures.begin(), run.measures.end(), name) > 1
            )
            {
                entries.fail
                (
                    "measures",
                    name,
                    "each once, of: " + chesil::listOfNames(known)
                );
            }
        }
    }
    return run;
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::refuseRestart(const Time& runTime)
{
    // Asked by one rank, since the master will soon make that file
    bool found = Pstream::master() && isFile(runTime.globalPath()/"grains.pvd");
    Pstream::scatter(found);
    if (found && runTime.startTime().value() > 0)
    {
        throw chesil::SetupError
        (
            "system/controlDict",
            "startFrom",
            "a start at " + runTime.timeName()
          + " s in a case with the grains of an earlier run",
            "startFrom startTime; startTime 0 (chesilDEM goes on from its"
            " checkpoints with startFrom latestTime; grains in flow cannot be"
            " restarted yet), or no grains.pvd, to place them anew at this time"
        );
    }
}


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
    const untrappedArithmetic guard;
    if (Pstream::master())
    {
        checkNames(runTime.globalPath()/runTime.constant()/header.name());
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
    const untrappedArithmetic guard;
    const checkedDictionary entries(properties, knownNames);

    caseSettings result;
    chesil::WorldSettings& world = result.world;
    world.gravity = entries.planeVector("gravity");
    const materialSettings materials = readMaterials(entries);
    world.materials = materials.materials;
    if (entries.found("damping"))
    {
        const checkedDictionary damping
            (entries.subDict("damping"), {"local", "viscous"});
        if (damping.found("local"))
        {
            world.localDamping =
                damping.numberIn("local", 0, 1 - SMALL, "a number in [0, 1)");
        }
        world.viscousDamping = damping.notNegative("viscous", 0);
    }
    world.contactStatistics = entries.flag("contactStatistics", false);
    readBoundary(entries, materials, world);
    shapeGroups shapes =
        readShapes(entries.subDict("shapes"), runTime.globalPath());
    world.grains = readGrains
    (
        entries.subDict("grains"),
        shapes,
        world,
        materials,
        runTime.globalPath()
    );
    world.contact =
        readContactLaws(entries.subDict("contact"), materials, shapes.shapes);
    world.shapes = std::move(shapes.shapes);
    if (world.grains.empty())
    {
        entries.fail
        (
            "grains", "an empty dictionary", "at least one dictionary of grains"
        );
    }
    checkOverlaps(entries, world);
    result.run = readRun(entries);
    world.energyLedger =
        std::count
        (
            result.run.measures.begin(), result.run.measures.end(), "energy"
        ) > 0;
    return result;
}


// ************************************************************************* //
