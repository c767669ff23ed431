#pragma once

#include "core/base/pose.hpp"
#include "core/geometry/outline.hpp"
#include "coupling/cellView/cellView.hpp"
#include "coupling/geometry/clippedRegion.hpp"
#include "coupling/geometry/inscribedPolygon.hpp"
#include "coupling/geometry/turnedOutline.hpp"

#include <vector>

namespace chesil
{

/// What one grain takes of one cell.
struct CoveredCell
{
    int cell = 0;
    /// Area of the cell that the grain covers [m2], > 0; divided by the cell's area: the solid fraction.
    /// Equal to the cell's area to the bit if the cell lies wholly inside, never more.
    double area = 0;
    /// Integral over the covered area of the position relative to the grain's centre [m3], world's
    /// directions: what a torque about the centre needs. Divided by the area: the covered part's centroid.
    Vector2 firstMoment = Vector2::Zero();
};

/// The cells that one convex grain covers or cuts, with the exact area of each from the curve itself. Keep
/// one object for each thread: it holds the workspace, and allocates only as long as that grows.
class GrainCells
{
public:
    /// Finds the cells for an outline in the grain's frame and the grain's pose in the mesh's frame [m].
    /// The part of the grain outside the mesh is covered by no cell. Two grains that overlap each count in
    /// full: sums over grains are the caller's. Derivation and figures: doc/solidFraction.md.
    void update(const Outline& outline, const Pose<2>& pose, const CellView& mesh);

    /// In rising order of cell numbers. Cells that share no more than rounding with the grain are left out.
    const std::vector<CoveredCell>& cells() const { return cells_; }

private:
    bool beyondReach(const Box& box, const Vector2& centre) const;
    void takeCorners(const CellPolygon& polygon, const Vector2& centre);
    void clip();
    RegionMoments coveredPart(const RegionMoments& wholeCell);

    TurnedOutline outline_;
    InscribedPolygon inscribed_;
    ClippedRegion region_;
    std::vector<int> candidates_;
    /// The current cell's corners relative to the grain's centre [m].
    std::vector<Vector2> corners_;
    std::vector<CoveredCell> cells_;
};

} // namespace chesil
