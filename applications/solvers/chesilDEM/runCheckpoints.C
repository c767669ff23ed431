/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "runCheckpoints.H"
#include "OSspecific.H"

#include "core/base/setupError.hpp"
#include "core/io/checkpointFolder.hpp"
#include "core/io/worldCheckpoint.hpp"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The one number of a section
template<class Number>
Number takeOne(chesil::CheckpointReader& reader, const std::string& name)
{
    const std::vector<Number> numbers = reader.take<Number>(name);
    if (numbers.size() != 1)
    {
        throw chesil::SetupError
        (
            reader.path(),
            name,
            std::to_string(numbers.size()) + " numbers",
            "one"
        );
    }
    return numbers.front();
}

} // End namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::runCheckpoints::runCheckpoints(const Time& runTime, bool active)
:
    folder_(runTime.globalPath()/"checkpoints"),
    active_(active)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::optional<Foam::checkpointedRun> Foam::runCheckpoints::resume
(
    const Time& runTime,
    chesil::World& world
) const
{
    const word from =
        runTime.controlDict().lookupOrDefault<word>("startFrom", "latestTime");
    if (from != "latestTime" || !isDir(folder_))
    {
        return std::nullopt;
    }
    const chesil::NewestCheckpoint newest =
        chesil::CheckpointFolder(folder_).newestValid();
    for (const std::string& reason : newest.broken)
    {
        Info<< "Passed over: " << reason.c_str() << endl;
    }
    if (!newest.path)
    {
        // To start anew would remove what the user wanted to go on from
        if (!newest.broken.empty())
        {
            throw chesil::SetupError
            (
                "checkpoints",
                "(all files)",
                "no whole checkpoint",
                "one to go on from, or startFrom startTime in"
                " system/controlDict to start anew"
            );
        }
        return std::nullopt;
    }
    chesil::CheckpointReader reader(*newest.path);
    checkpointedRun run;
    run.time = takeOne<double>(reader, "time");
    run.step = label(takeOne<std::uint64_t>(reader, "step"));
    run.timeStep = takeOne<double>(reader, "timeStep");
    run.pictureTimes = reader.take<double>("pictureTimes");
    try
    {
        world.resume(chesil::takeState(reader));
    }
    catch (const chesil::ValueError& error)
    {
        throw error.at(*newest.path, "(state)");
    }
    // A state goes on under the strain that the case asks for now
    if (const auto& cell = world.settings().cell)
    {
        if (world.cell()->velocityGradient != cell->velocityGradient)
        {
            world.setVelocityGradient(cell->velocityGradient);
        }
    }
    reader.finish();
    Info<< "Goes on from checkpoints/" << fileName(*newest.path).name().c_str()
        << ", step " << run.step << " at " << run.time << " s" << endl;
    return run;
}


void Foam::runCheckpoints::startAnew() const
{
    for (const fileName& name : readDir(folder_, fileName::FILE))
    {
        if (name.find("checkpoint_") == 0)
        {
            rm(folder_/name);
        }
    }
}


void Foam::runCheckpoints::write
(
    const checkpointedRun& run,
    const chesil::World& world
) const
{
    if (!active_)
    {
        return;
    }
    mkDir(folder_);
    chesil::CheckpointWriter writer;
    writer.add("timeStep", std::vector<double>{run.timeStep});
    writer.add("pictureTimes", run.pictureTimes);
    chesil::addState(writer, world.state());
    chesil::CheckpointFolder(folder_).write
        (std::move(writer), std::uint64_t(run.step), run.time);
}


// ************************************************************************* //
