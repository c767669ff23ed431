/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "chesilGrains.H"

#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"
#include "fvMesh.H"

#include "flowChecks.H"
#include "checkedDictionary.H"
#include "meshCellView.H"
#include "rankSums.H"
#include "readingGuards.H"
#include "worldSettingsReader.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(chesilGrains, 0);
    addToRunTimeSelectionTable(option, chesilGrains, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The velocity in the plane, as the coupling asks for it
struct planeVelocity
{
    const Foam::vectorField& U;

    chesil::Vector2 operator()(int cell) const
    {
        return {U[cell].x(), U[cell].y()};
    }
};

} // End namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fv::chesilGrains::build()
{
    const Time& runTime = mesh_.time();
    requireField<volVectorField>(mesh_, coeffs_, "U");
    requireField<volScalarField>(mesh_, coeffs_, "nu");
    const autoPtr<IOdictionary> properties = chesilProperties(runTime);
    const caseSettings settings = readCase(properties(), runTime);
    const fluidSettings fluid = readFluid(properties());
    fluidDensity_ = fluid.density;

    checkUse(settings.world, mesh_, fieldNames_.first());

    cells_ = cellViewOf(mesh_);
    world_.reset(new chesil::World(settings.world));
    forcing_.reset
    (
        new chesil::GrainForcing(*world_, cells_, chesil::PenaltyRate())
    );
    response_.reset
    (
        new chesil::GrainResponse
            (*world_, fluidDensity_, settings.run.shareOfStable)
    );
    loads_ = chesil::GrainLoads(world_->bodies().size());
    outside_.assign(world_->bodies().size(), false);

    forcing_->updateGeometry(*world_);
    updateSolidFraction();
    reportResolution();
}


void Foam::fv::chesilGrains::openOutput()
{
    const Time& runTime = mesh_.time();
    refuseRestart(runTime);
    if (Pstream::master())
    {
        pictures_.reset(new chesil::VtkOutput(runTime.globalPath(), *world_));
        pictures_->write(*world_, runTime.startTime().value());
    }
    series_.reset(new grainSeries(name_, runTime));
}


void Foam::fv::chesilGrains::checkCovered()
{
    const std::vector<double> covered = sumOverRanks(forcing_->coveredAreas());
    for (std::size_t i = 0; i < covered.size(); ++i)
    {
        constexpr scalar enough = 0.9;
        const scalar share = covered[i]/world_->areaOf(i);
        if (share < enough && !outside_[i])
        {
            outside_[i] = true;
            WarningInFunction
                << "at time " << mesh_.time().value() << " s the mesh holds "
                << 100*share << " % of grain " << label(i) << " at ("
                << world_->bodies().pose[i].position.x() << ' '
                << world_->bodies().pose[i].position.y()
                << "): the fluid does not feel the rest. Grains meet the walls of"
                << " constant/chesilProperties, not the mesh's patches" << endl;
        }
    }
}


void Foam::fv::chesilGrains::reportResolution() const
{
    scalar widest = 0;
    for (const int cell : forcing_->touched())
    {
        widest = max(widest, cells_.width(cell));
    }
    reduce(widest, maxOp<scalar>());
    scalar smallest = GREAT;
    for (std::size_t i = 0; i < world_->bodies().size(); ++i)
    {
        smallest = min(smallest, world_->sizeOf(i));
    }
    Info<< "    Grains " << label(world_->bodies().size());
    if (widest > 0)
    {
        Info<< ", at least " << smallest/widest << " cells a diameter";
    }
    Info<< endl;
}


void Foam::fv::chesilGrains::moveTo
(
    const Time& runTime,
    const volVectorField& U
)
{
    // A number out of range ends the run below, by name, not by a signal
    const untrappedArithmetic guard;
    writeSeries();
    const chesil::StepStatus status =
        response_->advance(loads_, runTime.deltaTValue());
    if (status != chesil::StepStatus::done)
    {
        FatalErrorInFunction
            << "at time " << runTime.value() << " s: "
            << chesil::describe(status, world_->brokenGrain()).c_str()
            << exit(FatalError);
    }

    forcing_->updateGeometry(*world_);
    const volScalarField& nu = mesh_.lookupObject<volScalarField>(viscosityName_);
    forcing_->updateRates
    (
        planeVelocity{U.primitiveField()},
        [&](int cell) { return nu[cell]; }
    );
    updateSolidFraction();
    checkCovered();

    unwritten_ = true;
    timeOfState_ = runTime.value();
    if (pictures_ && runTime.writeTime())
    {
        pictures_->write(*world_, runTime.value());
    }
}


void Foam::fv::chesilGrains::updateSolidFraction()
{
    scalarField& fraction = solidFraction_.primitiveFieldRef();
    fraction = 0;
    for (const int cell : forcing_->touched())
    {
        fraction[cell] = forcing_->fraction(cell);
    }
}


void Foam::fv::chesilGrains::writeSeries()
{
    if (unwritten_)
    {
        series_->write
        (
            timeOfState_, *world_, response_->hydrodynamicLoads(loads_)
        );
        unwritten_ = false;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fv::chesilGrains::chesilGrains
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    namedFieldsOption(name, modelType, dict, mesh),
    viscosityName_(coeffs_.lookupOrDefault<word>("nu", "nu")),
    solidFraction_
    (
        IOobject
        (
            "solidFraction",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimless, Zero)
    )
{
    setFields({coeffs_.lookupOrDefault<word>("U", "U")});
    try
    {
        checkedDictionary(coeffs_, {"type", "active", "log", "U", "nu"});
        build();
    }
    catch (const chesil::SetupError& error)
    {
        FatalErrorInFunction << error.what() << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::fv::chesilGrains::~chesilGrains()
{
    writeSeries();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fv::chesilGrains::addSup(fvMatrix<vector>& eqn, const label)
{
    const Time& runTime = mesh_.time();
    if (mesh_.changing())
    {
        FatalErrorInFunction
            << "fvOption " << name_ << ": the mesh moves or changes, and"
            << " chesilGrains knows it as it was at the start"
            << exit(FatalError);
    }
    if (runTime.timeIndex() != timeIndex_)
    {
        try
        {
            if (!series_)
            {
                openOutput();
            }
            moveTo(runTime, eqn.psi());
        }
        catch (const chesil::SetupError& error)
        {
            FatalErrorInFunction << error.what() << exit(FatalError);
        }
        timeIndex_ = runTime.timeIndex();
    }

    // eqn stands on the right-hand side: + rate*velocity - Sp(rate, U)
    scalarField& diag = eqn.diag();
    vectorField& source = eqn.source();
    const scalarField& V = mesh_.V();
    for (const int cell : forcing_->touched())
    {
        const scalar rate = forcing_->rate(cell)*V[cell];
        const chesil::Vector2& velocity = forcing_->velocity(cell);
        diag[cell] -= rate;
        source[cell] -= rate*vector(velocity.x(), velocity.y(), 0);
    }
}


void Foam::fv::chesilGrains::addSup
(
    const volScalarField&,
    fvMatrix<vector>&,
    const label
)
{
    FatalErrorInFunction
        << "fvOption " << name_ << ": the solver's momentum equation carries a"
        << " density; chesilGrains works with incompressible solvers, as"
        << " pimpleFoam is one" << exit(FatalError);
}


void Foam::fv::chesilGrains::correct(volVectorField& U)
{
    chesil::GrainLoads own(world_->bodies().size());
    forcing_->addLoads
        (planeVelocity{U.primitiveField()}, fluidDensity_, own);
    loads_ = sumOverRanks(own);
}


bool Foam::fv::chesilGrains::read(const dictionary& dict)
{
    // Grains are read once, when the run starts
    return option::read(dict);
}


// ************************************************************************* //
