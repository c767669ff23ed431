/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "grainSeries.H"

#include "OSspecific.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::grainSeries::grainSeries(const word& name, const Time& runTime)
{
    if (!Pstream::master())
    {
        return;
    }
    const fileName folder
    (
        runTime.globalPath()/"postProcessing"/name
       /Time::timeName(runTime.startTime().value())
    );
    mkDir(folder);
    file_.reset(new OFstream(folder/"grains.dat"));
    file_().precision(12);
    file_()
        << "# Time [s]\tgrain\tx [m]\ty [m]\tangle [rad]\tvx [m/s]\tvy [m/s]"
        << "\tangularVelocity [rad/s]\tFx [N/m]\tFy [N/m]\ttorque [N m/m]" << nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::grainSeries::write
(
    scalar time,
    const chesil::World& world,
    const chesil::GrainLoads& loads
)
{
    if (!file_.valid())
    {
        return;
    }
    const chesil::Bodies<2>& bodies = world.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const chesil::Pose<2>& pose = bodies.pose[i];
        file_()
            << time << tab << label(i) << tab
            << pose.position.x() << tab << pose.position.y() << tab
            << pose.rotation.angle() << tab
            << bodies.velocity[i].x() << tab << bodies.velocity[i].y() << tab
            << bodies.angularVelocity[i] << tab
            << loads.force[i].x() << tab << loads.force[i].y() << tab
            << loads.torque[i] << nl;
    }
    file_().flush();
}


// ************************************************************************* //
