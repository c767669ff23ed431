/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "worldSeries.H"

#include "OSspecific.H"

#include "core/measure/energy.hpp"

#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::fileName folderOf(const Foam::Time& runTime)
{
    const Foam::fileName folder
        (runTime.globalPath()/"postProcessing"/"chesilDEM"/runTime.timeName());
    Foam::mkDir(folder);
    return folder;
}

} // End namespace


// * * * * * * * * * * * * * * * * worldSummary  * * * * * * * * * * * * * * //

Foam::worldSummary::worldSummary(const chesil::World& world)
:
    kineticEnergy(chesil::kineticEnergy(world.bodies())),
    contactEnergy
    (
        world.contactEnergy()
    ),
    contacts(0),
    largestOverlap(world.largestRelativeOverlap()),
    meanSpeed(0)
{
    for (const chesil::Vector2& velocity : world.bodies().velocity)
    {
        meanSpeed += velocity.norm()/scalar(world.bodies().size());
    }
    for (const chesil::Contact<2>& contact : world.contacts())
    {
        contacts += contact.depth > 0;
    }
}


Foam::scalar Foam::worldSummary::unrest() const
{
    // That of cohesion is negative
    return contactEnergy != 0 ? kineticEnergy/mag(contactEnergy) : VGREAT;
}


std::string Foam::worldSummary::text() const
{
    char text[160];
    std::snprintf
    (
        text, sizeof text,
        "kinetic %.3g J  contact %.3g J  contacts %d  largest overlap %.3g %%",
        kineticEnergy, contactEnergy, int(contacts), 100*largestOverlap
    );
    return text;
}


// * * * * * * * * * * * * * * * * worldSeries * * * * * * * * * * * * * * * //

Foam::worldSeries::worldSeries(const Time& runTime)
:
    file_(folderOf(runTime)/"world.dat")
{
    file_.precision(12);
    file_ << "# Time [s]\tkineticEnergy [J]\tcontactEnergy [J]\tcontacts"
          << "\tlargestOverlap [size]\tmeanSpeed [m/s]" << endl;
}


void Foam::worldSeries::write(scalar time, const worldSummary& summary)
{
    file_ << time << '\t' << summary.kineticEnergy << '\t'
          << summary.contactEnergy << '\t' << summary.contacts << '\t'
          << summary.largestOverlap << '\t' << summary.meanSpeed << endl;
}


// ************************************************************************* //
