/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
\*---------------------------------------------------------------------------*/

#include "grainChecks.H"
#include "checkedDictionary.H"
#include "shapeSettings.H"

#include "core/base/setupError.hpp"
#include "core/world/pairDistance.hpp"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- How far a grain reaches into a wall [m]; negative before it
Foam::scalar depthInWall
(
    const chesil::Shape& shape,
    const chesil::GrainState& grain,
    const chesil::PlaneWall<2>& wall
)
{
    const chesil::Pose<2> pose
        {grain.position, chesil::Rotation<2>(grain.angle)};
    if (wall.plate)
    {
        return -chesil::pairDistance
            (shape, pose, wall.plate->outline, wall.pose()).distance;
    }
    const chesil::Vector2 foot = pose.toWorld
    (
        chesil::support(shape, pose.rotation.applyInverse(-wall.normal))
    );
    return -wall.distance(foot);
}

} // End namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

chesil::PlacementBox Foam::readBox(const checkedDictionary& entries)
{
    const checkedDictionary box(entries.subDict("box"), {"lower", "upper"});
    return {box.planeVector("lower"), box.planeVector("upper")};
}


void Foam::checkWalls
(
    const checkedDictionary& entries,
    const word& name,
    const std::vector<chesil::GrainState>& grains,
    const shapeGroups& shapes,
    const std::vector<chesil::PlaneWall<2>>& walls
)
{
    constexpr scalar allowedShare = 0.1;
    for (const chesil::GrainState& grain : grains)
    {
        if (grain.driven)
        {
            continue;
        }
        const chesil::NamedShape& named =
            shapes.shapes[std::size_t(grain.shape)];
        for (const chesil::PlaneWall<2>& wall : walls)
        {
            const scalar depth = depthInWall(named.shape, grain, wall);
            if (depth > allowedShare*chesil::boundingRadius(named.shape))
            {
                entries.fail
                (
                    name,
                    "a grain " + named.name + " that reaches "
                  + chesil::numberText(depth) + " m into wall " + wall.name,
                    wall.plate
                  ? "grains that start beside the wall"
                  : "grains that start between the walls: one bigger than"
                    " the box never fits"
                );
            }
        }
    }
}


void Foam::checkCell
(
    const checkedDictionary& entries,
    const chesil::PeriodicCell& cell
)
{
    const chesil::PlacementBox box = readBox(entries);
    const chesil::Vector2 upper = cell.lower() + cell.first() + cell.second();
    if
    (
        (box.lower - cell.lower()).minCoeff() < 0
     || (upper - box.upper).minCoeff() < 0
    )
    {
        entries.fail
        (
            "box", "a box that reaches out of the cell", "a box within the cell"
        );
    }
}


// ************************************************************************* //
