#pragma once

#include "coupling/geometry/halfPlane.hpp"
#include "coupling/geometry/regionMoments.hpp"
#include "coupling/geometry/turnedOutline.hpp"

#include <vector>

namespace chesil
{

/// The part of a grain inside some half-planes (those left of a convex cell's edges, say), held as a closed
/// counter-clockwise chain of curve parts and straight chords. Works on curves of any kind that partsInside
/// and sliverMoments know; no curve is ever replaced by chords. Reuse one object: it then allocates nothing.
class ClippedRegion
{
public:
    /// Begins with the whole grain; the outline must stay alive while the region is in use.
    void start(const TurnedOutline& outline);

    /// Takes away what lies right of the line (Sutherland & Hodgman 1974, on curves).
    void cut(const HalfPlane& plane);

    bool empty() const { return pieces_.empty(); }

    /// True if nothing of the grain's own outline is left: what remains is bounded by the lines alone.
    bool boundedByLines() const;

    /// Closed chain; each piece ends where the next one starts.
    const std::vector<BoundaryPiece>& pieces() const { return pieces_; }

    /// About the grain's centre, exact to rounding.
    RegionMoments moments() const;

private:
    void append(const BoundaryPiece& piece);
    void appendInside(const BoundaryPiece& piece, const HalfPlane& plane);

    const TurnedOutline* outline_ = nullptr;
    std::vector<BoundaryPiece> pieces_;
    std::vector<BoundaryPiece> kept_;
};

} // namespace chesil
