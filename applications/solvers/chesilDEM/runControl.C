/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "runControl.H"
#include "checkedDictionary.H"
#include "runCheckpoints.H"
#include "worldSettingsReader.H"

#include "core/base/setupError.hpp"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Is the write interval a time, not a number of steps?
bool writesInTime(const Foam::Time& runTime)
{
    const Foam::word control =
        runTime.controlDict().lookupOrDefault<Foam::word>("writeControl", "timeStep");
    return control != "timeStep" && control != "none";
}


//- The longest step up to `most` [s] of which the write interval is a multiple,
//  so that the states written are those of the times asked for
Foam::scalar dividing(const Foam::Time& runTime, Foam::scalar most)
{
    const Foam::checkedDictionary control(runTime.controlDict());
    const Foam::scalar whole =
        writesInTime(runTime)
      ? control.positive("writeInterval")
      : runTime.endTime().value() - runTime.value();
    return whole/std::ceil(whole/std::min(most, whole));
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::isNewWrite(const Time& runTime)
{
    if (!writesInTime(runTime))
    {
        return true;
    }
    const scalar interval =
        checkedDictionary(runTime.controlDict()).positive("writeInterval");
    const scalar step = runTime.deltaTValue();
    const auto index = [&](scalar time)
    {
        return label((time - runTime.startTime().value() + 0.5*step)/interval);
    };
    return index(runTime.value()) > index(runTime.value() - step);
}


void Foam::checkControl(const Time& runTime)
{
    const checkedDictionary control(runTime.controlDict());
    control.positive("deltaT");
    if (!(runTime.endTime().value() > runTime.value()))
    {
        control.fail
        (
            "endTime",
            chesil::numberText(runTime.endTime().value()),
            "a time after the start at " + chesil::numberText(runTime.value())
        );
    }
    if (writesInTime(runTime))
    {
        control.positive("writeInterval");
    }
}


Foam::scalar Foam::timeStepOf
(
    const Time& runTime,
    const chesil::World& world,
    const runSettings& run,
    const std::optional<checkpointedRun>& earlier
)
{
    const scalar stable = world.stableTimeStep();
    if (runTime.controlDict().lookupOrDefault("adjustTimeStep", false))
    {
        // A run that goes on keeps its step, so that it goes on to the bit
        const scalar most = run.shareOfStable*stable;
        const scalar step =
            earlier && earlier->timeStep <= most
          ? earlier->timeStep
          : dividing(runTime, most);
        Info<< "Time step " << step << " s, " << run.shareOfStable
            << " of the stable " << stable << " s" << endl;
        return step;
    }

    const scalar step = runTime.deltaTValue();
    if (step > stable && !run.allowUnstable)
    {
        throw chesil::SetupError
        (
            "system/controlDict",
            "deltaT",
            chesil::numberText(step) + " s",
            "at most the stable step of " + chesil::numberText(stable)
          + " s (or adjustTimeStep yes; or timeStep { allowUnstable yes; } in"
            " constant/chesilProperties)"
        );
    }
    Info<< "Time step " << step << " s, " << step/stable
        << " of the stable " << stable << " s" << endl;
    return step;
}


// ************************************************************************* //
