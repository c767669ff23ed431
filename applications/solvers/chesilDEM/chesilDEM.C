/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    chesilDEM

Group
    grpChesil

Description
    Dry runs of smooth irregular grains, without a mesh.

    Reads constant/chesilProperties (worldSettingsReader.H tells the entries)
    and system/controlDict (times and writing; `adjustTimeStep yes` takes a
    share of the stable step, else deltaT is used and checked).

    Writes grains.pvd with grains/grains_<n>.vtp for ParaView,
    postProcessing/chesilDEM/<time>/world.dat, and grains.csv, from which
    another case can begin (type file in grainSettings.H).

Usage
    \b chesilDEM [OPTION]

    Options:
      - \par -case \<dir\>
        The case to run, default: the current folder

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"

#include "progressLine.H"
#include "readingGuards.H"
#include "runCheckpoints.H"
#include "runControl.H"
#include "worldMeasures.H"
#include "worldSeries.H"
#include "worldSettingsReader.H"

#include "core/base/setupError.hpp"
#include "core/io/vtkOutput.hpp"
#include "core/io/worldGrainTable.hpp"

#include <cstdlib>
#include <exception>
#include <iostream>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Before the run rather than at the first write time
static void checkTableNames(const chesil::WorldSettings& world)
{
    try
    {
        chesil::requireTableNames(world.shapes, world.materials);
    }
    catch (const chesil::ValueError& error)
    {
        throw error.at("constant/chesilProperties", "shapes, materials");
    }
}


static int run(Time& runTime)
{
    // A number out of range ends the run below, by name, not by a signal
    const untrappedArithmetic guard;
    refuseRestart(runTime);
    const autoPtr<IOdictionary> properties = chesilProperties(runTime);
    const caseSettings settings = readCase(properties(), runTime);
    checkTableNames(settings.world);
    chesil::World world(settings.world);
    Info<< "Grains " << label(world.bodies().size())
        << ", shapes " << label(settings.world.shapes.size())
        << ", walls " << label(settings.world.walls.size()) << endl;

    const runCheckpoints checkpoints(runTime, settings.run.checkpoints);
    const std::optional<checkpointedRun> earlier =
        checkpoints.resume(runTime, world);
    const scalar timeStep =
        timeStepOf(runTime, world, settings.run, earlier);
    if (earlier)
    {
        runTime.setTime(earlier->time, earlier->step);
    }
    else
    {
        checkpoints.startAnew();
        world.updateForces();
    }
    runTime.setDeltaT(timeStep, false);

    chesil::VtkOutput pictures
    (
        runTime.globalPath(),
        world,
        earlier ? earlier->pictureTimes : std::vector<double>(),
        settings.run.forceChains
    );
    worldSeries series(runTime);
    worldMeasures measures(runTime, settings.run.measures, world);
    progressLine progress(runTime.value(), runTime.endTime().value());

    const auto writeRows = [&](const worldSummary& summary)
    {
        series.write(runTime.value(), summary);
        measures.write(runTime.value(), world);
    };
    const auto writeState = [&]()
    {
        pictures.write(world, runTime.value());
        chesil::writeGrainTable
        (
            runTime.globalPath()/"grains.csv",
            chesil::grainRows(world, settings.world.grains)
        );
        checkpoints.write
        (
            {runTime.value(), runTime.timeIndex(), timeStep, pictures.times()},
            world
        );
    };
    if (!earlier)
    {
        pictures.write(world, runTime.value());
    }
    writeRows(worldSummary(world));

    std::string end = "end time reached";
    label steps = 0;
    bool written = true;
    label rowsSinceState = 0;
    // Time::run() would run function objects, which leave folders behind
    const scalar lastStart = runTime.endTime().value() - 0.5*timeStep;
    while (runTime.value() < lastStart)
    {
        ++runTime;
        ++steps;
        const chesil::StepStatus status = world.step(timeStep);
        if (status != chesil::StepStatus::done)
        {
            Info<< "FAILED at time " << runTime.value() << " s: "
                << chesil::describe(status, world.brokenGrain()).c_str() << endl;
            return 1;
        }

        written =
            runTime.writeTime() && (steps > 1 || !earlier || isNewWrite(runTime));
        if (written || progress.due())
        {
            const worldSummary summary(world);
            progress.print(runTime.value(), summary.text());
            if (written)
            {
                writeRows(summary);
                if (++rowsSinceState == settings.run.statesEvery)
                {
                    writeState();
                    rowsSinceState = 0;
                }
                if (summary.unrest() < settings.run.stopAtRest)
                {
                    end = "at rest";
                    break;
                }
            }
        }
    }

    const worldSummary summary(world);
    if (!written)
    {
        writeRows(summary);
    }
    if (!written || rowsSinceState > 0)
    {
        writeState();
    }
    Info<< nl << "End: " << end.c_str() << " at " << runTime.value() << " s after "
        << steps << " steps in " << progress.elapsed() << " s ("
        << scalar(steps)*scalar(world.bodies().size())/max(progress.elapsed(), SMALL)
        << " grain steps a second)" << nl
        << "     " << summary.text().c_str() << nl
        << "     kinetic over contact energy " << summary.unrest() << nl;
    if (settings.world.contactStatistics)
    {
        const chesil::ContactStatistics& cost = world.contactStatistics();
        Info<< "     contact queries of grains " << scalar(cost.queries)
            << ", in contact " << scalar(cost.contacts)
            << ", support calls a query "
            << scalar(cost.supportCalls)/max(scalar(cost.queries), scalar(1))
            << ", sweeps over all directions " << scalar(cost.sweeps) << nl;
    }
    if (world.doubtfulQueries() > 0)
    {
        Info<< "     " << label(world.doubtfulQueries())
            << " pair queries ended without the full answer" << nl;
    }
    Info<< endl;
    return 0;
}


//- Time divides by the write interval before anyone can check it
static autoPtr<Time> makeTime(const argList& args)
{
    const untrappedArithmetic guard;
    autoPtr<Time> runTime(new Time(Time::controlDictName, args));
    checkControl(*runTime);
    return runTime;
}


int main(int argc, char *argv[])
{
    argList::addNote("Dry runs of smooth irregular grains, without a mesh");
    argList::noParallel();
    argList::noFunctionObjects();

    const argList args(argc, argv);
    int status = 1;
    if (args.checkRootCase())
    {
        try
        {
            autoPtr<Time> runTime = makeTime(args);
            status = run(runTime.ref());
        }
        catch (const std::exception& problem)
        {
            std::cerr << "chesilDEM: " << problem.what() << std::endl;
        }
    }
    if (status != 0)
    {
        // The end of argList would make the exit status 0
        std::exit(status);
    }
    return 0;
}


// ************************************************************************* //
