/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "meshCellView.H"

#include "emptyPolyPatch.H"
#include "fvMesh.H"

#include "core/base/setupError.hpp"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::fvMesh;
using Foam::label;

[[noreturn]] void failMesh(const std::string& found)
{
    throw chesil::SetupError
    (
        "constant/polyMesh",
        "boundary",
        found,
        "a 2D mesh: one layer of cells between empty patches, flat in the x-y"
        " plane"
    );
}

//- The face of each cell on the empty patch that looks along +z, or -1
Foam::labelList upperFaces(const fvMesh& mesh)
{
    Foam::labelList faces(mesh.nCells(), -1);
    for (const Foam::polyPatch& patch : mesh.boundaryMesh())
    {
        if (!Foam::isA<Foam::emptyPolyPatch>(patch))
        {
            continue;
        }
        forAll(patch, i)
        {
            if (patch.faceAreas()[i].z() > 0)
            {
                faces[patch.faceCells()[i]] = patch.start() + i;
            }
        }
    }
    return faces;
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

chesil::CellView Foam::cellViewOf(const fvMesh& mesh)
{
    const Vector<label>& solved = mesh.geometricD();
    if (solved.x() != 1 || solved.y() != 1 || solved.z() != -1)
    {
        failMesh
        (
            "a mesh with " + std::to_string(mesh.nGeometricD())
          + " dimensions, geometricD ("
          + std::to_string(solved.x()) + " " + std::to_string(solved.y()) + " "
          + std::to_string(solved.z()) + ")"
        );
    }

    std::vector<int> offsets{0};
    std::vector<chesil::Vector2> vertices;
    const labelList upper = upperFaces(mesh);
    forAll(upper, cell)
    {
        if (upper[cell] < 0)
        {
            failMesh("cell " + std::to_string(cell) + " without an upper empty face");
        }
        for (const label vertex : mesh.faces()[upper[cell]])
        {
            const point& p = mesh.points()[vertex];
            vertices.emplace_back(p.x(), p.y());
        }
        offsets.push_back(static_cast<int>(vertices.size()));
    }
    try
    {
        return chesil::CellView(std::move(offsets), std::move(vertices));
    }
    catch (const chesil::ValueError& error)
    {
        failMesh(error.found());
    }
}


// ************************************************************************* //
