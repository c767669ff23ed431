#pragma once

#include "core/base/pose.hpp"
#include "core/geometry/outline.hpp"
#include "coupling/cellView/box.hpp"

#include <vector>

namespace chesil
{

/// A piece of a region's boundary: the part of curve number `curve` from parameter `from` to `to`, or the
/// straight line from `start` to `end` [m] if `curve` is `chord`.
struct BoundaryPiece
{
    static constexpr int chord = -1;

    int curve = chord;
    double from = 0;
    double to = 0;
    Vector2 start = Vector2::Zero();
    Vector2 end = Vector2::Zero();
};

/// A grain's outline turned into the world's directions, about the grain's centre: positions are small
/// numbers then, however far the grain is from the world's origin.
class TurnedOutline
{
public:
    /// Takes an outline in the grain's frame (closed, counter-clockwise, see Outline) and turns it. Each
    /// piece ends where the next one starts, to the bit. Allocates only on the first use.
    void set(const Outline& outline, const Rotation<2>& rotation);

    /// Curves by number; the arcs' centres and the control points are relative to the grain's centre [m].
    const Outline& curves() const { return curves_; }

    /// The whole outline as a chain.
    const std::vector<BoundaryPiece>& chain() const { return chain_; }

    /// Holds the outline, relative to the grain's centre [m]; tight for whole ellipses and polygons.
    const Box& box() const { return box_; }

    /// No point of the outline is further from the grain's centre [m].
    double outerRadius() const { return outerRadius_; }

private:
    Outline curves_;
    std::vector<BoundaryPiece> chain_;
    Box box_;
    double outerRadius_ = 0;
};

} // namespace chesil
