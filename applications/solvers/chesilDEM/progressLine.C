/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "progressLine.H"

#include "messageStream.H"

#include <cstdio>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::progressLine::progressLine(scalar startTime, scalar endTime)
:
    startTime_(startTime),
    endTime_(endTime),
    start_(clock::now()),
    last_(start_)
{}


bool Foam::progressLine::due() const
{
    return clock::now() - last_ > std::chrono::seconds(2);
}


void Foam::progressLine::print(scalar time, const std::string& more)
{
    last_ = clock::now();
    const scalar share = (time - startTime_)/(endTime_ - startTime_);
    const scalar left = share > 0 ? elapsed()*max(1 - share, scalar(0))/share : 0;
    char text[160];
    std::snprintf
    (
        text, sizeof text, "Time = %-10.5g %3.0f %%  at most %.0f s left  ",
        time, 100*share, left
    );
    Info<< text << more.c_str() << endl;
}


Foam::scalar Foam::progressLine::elapsed() const
{
    return std::chrono::duration<scalar>(clock::now() - start_).count();
}


// ************************************************************************* //
