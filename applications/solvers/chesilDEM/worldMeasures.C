/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "worldMeasures.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::worldMeasures::worldMeasures
(
    const Time& runTime,
    const std::vector<std::string>& names,
    const chesil::World& world
)
:
    files_(label(names.size()))
{
    const fileName folder
        (runTime.globalPath()/"postProcessing"/"chesilDEM"/runTime.timeName());
    mkDir(folder);
    forAll(files_, i)
    {
        const std::string& name = names[std::size_t(i)];
        measures_.push_back(&chesil::measureNamed(name));
        files_.set(i, new OFstream(folder/(name + ".dat")));
        files_[i].precision(12);
        files_[i] << "# Time [s]";
        for (const std::string& column : measures_.back()->columns(world))
        {
            files_[i] << '\t' << column.c_str();
        }
        files_[i] << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::worldMeasures::write(scalar time, const chesil::World& world)
{
    forAll(files_, i)
    {
        files_[i] << time;
        for (const double value : measures_[std::size_t(i)]->row(world))
        {
            files_[i] << '\t' << value;
        }
        files_[i] << endl;
    }
}


// ************************************************************************* //
