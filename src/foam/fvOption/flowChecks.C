/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "flowChecks.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::checkUse
(
    const chesil::WorldSettings& world,
    const fvMesh& mesh,
    const word& U
)
{
    if (world.localDamping > 0)
    {
        throw chesil::SetupError
        (
            "constant/chesilProperties",
            "damping.local",
            chesil::numberText(world.localDamping),
            "none in flow: it would damp the fluid's load, too"
            " (contact.restitution takes energy from contacts)"
        );
    }
    if (world.cell)
    {
        throw chesil::SetupError
        (
            "constant/chesilProperties",
            "cell",
            "a periodic cell (that of cell or loading)",
            "none in flow: the mesh does not repeat itself"
        );
    }
    const word steady("steadyState");
    const word ddt("ddt(" + U + ')');
    const bool allDriven = std::all_of
    (
        world.grains.begin(),
        world.grains.end(),
        [](const chesil::GrainState& grain) { return grain.driven; }
    );
    if (word(mesh.ddtScheme(ddt)) == steady && !allDriven)
    {
        throw chesil::SetupError
        (
            "system/fvSchemes",
            ddt,
            steady,
            "a scheme in time, since grains move (or driven yes for all grains)"
        );
    }
}


// ************************************************************************* //
