#include "coupling/geometry/solidFraction.hpp"

#include "core/base/tolerances.hpp"

#include <algorithm>

namespace chesil
{

namespace
{

/// Rounding of the sums below, in units of the machine's.
constexpr double roundings = 16;

/// The outline's box in the mesh's frame, wide enough for the rounding of the shift.
Box shiftedBox(const Box& box, const Vector2& centre)
{
    const Vector2 reach = box.high.cwiseAbs().cwiseMax(box.low.cwiseAbs()) + centre.cwiseAbs();
    const Vector2 margin = roundings * tolerances::epsilon * reach;
    return {box.low + centre - margin, box.high + centre + margin};
}

} // namespace

void GrainCells::update(const Outline& outline, const Pose<2>& pose, const CellView& mesh)
{
    outline_.set(outline, pose.rotation);
    inscribed_.set(outline_.curves());
    mesh.cellsOverlapping(shiftedBox(outline_.box(), pose.position), candidates_);

    cells_.clear();
    for (const int cell : candidates_)
    {
        if (beyondReach(mesh.box(cell), pose.position))
        {
            continue;
        }
        takeCorners(mesh.polygon(cell), pose.position);
        const double cellArea = mesh.area(cell);
        const RegionMoments covered = coveredPart({cellArea, cellArea * (mesh.centre(cell) - pose.position)});
        // The outline's own rounding along the cell.
        const double nothing = roundings * tolerances::epsilon * outline_.outerRadius() * mesh.width(cell);
        if (covered.area > std::min(nothing, cellArea / 2))
        {
            cells_.push_back({cell, covered.area, covered.first});
        }
    }
}

bool GrainCells::beyondReach(const Box& box, const Vector2& centre) const
{
    const Vector2 nearest = centre.cwiseMax(box.low).cwiseMin(box.high);
    const double reach = outline_.outerRadius() * (1 + roundings * tolerances::epsilon);
    return (nearest - centre).squaredNorm() > reach * reach;
}

void GrainCells::takeCorners(const CellPolygon& polygon, const Vector2& centre)
{
    corners_.clear();
    for (const Vector2& corner : polygon)
    {
        corners_.push_back(corner - centre);
    }
}

/// The edge that has the grain's centre furthest outside comes first: it takes away most of the outline.
void GrainCells::clip()
{
    const std::size_t count = corners_.size();
    const auto edge = [&](std::size_t i)
    {
        const Vector2& start = corners_[i % count];
        return HalfPlane{start, corners_[(i + 1) % count] - start};
    };
    std::size_t first = 0;
    double least = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
        const double distance = edge(i).distance(Vector2::Zero());
        if (distance < least)
        {
            least = distance;
            first = i;
        }
    }
    region_.start(outline_);
    for (std::size_t i = 0; i < count && !region_.empty(); ++i)
    {
        region_.cut(edge(first + i));
    }
}

RegionMoments GrainCells::coveredPart(const RegionMoments& wholeCell)
{
    if (inscribed_.contains(corners_))
    {
        return wholeCell;
    }
    clip();
    const RegionMoments part = region_.moments();
    // A whole cell keeps its area to the bit. Rounding alone makes a part larger than the whole, or leaves
    // chords of no area without a curve where the grain only touches the cell.
    const bool whole = region_.boundedByLines() && part.area > wholeCell.area / 2;
    return whole || part.area > wholeCell.area ? wholeCell : part;
}

} // namespace chesil
