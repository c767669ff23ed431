/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "worldSettingsReader.H"
#include "checkedDictionary.H"
#include "contactSettings.H"
#include "grainSettings.H"
#include "readingGuards.H"
#include "shapeSettings.H"

#include "IFstream.H"
#include "OSspecific.H"

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
    "gravity", "material", "materials", "contact", "damping", "walls", "shapes", "grains",
    "timeStep", "stopAtRest", "contactStatistics", "measures",
    "checkpoints", "fluid", "variables"
};

//- applications/solvers/chesilDEM/worldMeasures.C computes them
const std::vector<std::string> knownMeasures
{
    "energy", "coordination", "stress", "fabric", "packing", "walls"
};

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

std::vector<chesil::PlaneWall<2>> readWalls
(
    const dictionary& dict,
    const Foam::materialSettings& materials
)
{
    std::vector<chesil::PlaneWall<2>> walls;
    const std::vector<Foam::word> names = checkedDictionary::subDictNames(dict);
    for (const Foam::word& name : names)
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

//- Grains that start inside each other would be shot apart; driven ones stay
void checkOverlaps
(
    const checkedDictionary& entries,
    const chesil::WorldSettings& settings
)
{
    constexpr scalar allowedShare = 0.1;
    chesil::World world(settings);
    world.updateForces();
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
    run.stopAtRest = entries.notNegative("stopAtRest", 0);
    if (entries.found("measures"))
    {
        run.measures = entries.words("measures");
        for (const std::string& name : run.measures)
        {
            if
            (
                std::count(knownMeasures.begin(), knownMeasures.end(), name) == 0
             || std::count(run.measures.begin(), run.measures.end(), name) > 1
            )
            {
                entries.fail
                (
                    "measures",
                    name,
                    "each once, of: " + chesil::listOfNames(knownMeasures)
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
    if (entries.found("walls"))
    {
        world.walls = readWalls(entries.subDict("walls"), materials);
    }
    shapeGroups shapes =
        readShapes(entries.subDict("shapes"), runTime.globalPath());
    world.grains = readGrains
    (
        entries.subDict("grains"), shapes, world.walls, materials
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
