#pragma once

#include "core/base/vector.hpp"
#include "coupling/cellView/box.hpp"
#include "coupling/cellView/boxBins.hpp"

#include <vector>

namespace chesil
{

/// The corners of one cell, counter-clockwise [m]; a view into a CellView, valid as long as that.
class CellPolygon
{
public:
    CellPolygon(const Vector2* begin, const Vector2* end) : begin_(begin), end_(end) {}

    const Vector2* begin() const { return begin_; }
    const Vector2* end() const { return end_; }
    int size() const { return static_cast<int>(end_ - begin_); }
    const Vector2& operator[](int i) const { return begin_[i]; }

private:
    const Vector2* begin_;
    const Vector2* end_;
};

/// A plane mesh, as one layer of cells extruded along z leaves it: the convex polygon of each cell in the
/// x-y plane [m], with what follows from it, and a search by place. Cells keep the numbers that they were
/// given in. They may be of any number of corners, graded, stretched, and need not cover a connected area.
class CellView
{
public:
    CellView() = default;

    /// Cell i has the corners vertices[offsets[i]] ... vertices[offsets[i + 1] - 1], counter-clockwise.
    /// Throws ValueError, naming the cell, if offsets do not rise from 0 to the number of vertices, or if a
    /// polygon is not finite, not convex or clockwise (see requireConvex). No cells at all are in order: a
    /// processor's share of the mesh may be empty in the plane's part that matters.
    CellView(std::vector<int> offsets, std::vector<Vector2> vertices);

    int size() const { return static_cast<int>(areas_.size()); }

    CellPolygon polygon(int cell) const
    {
        return CellPolygon(vertices_.data() + offsets_[cell], vertices_.data() + offsets_[cell + 1]);
    }

    /// Area [m2].
    double area(int cell) const { return areas_[cell]; }

    /// Centroid [m].
    const Vector2& centre(int cell) const { return centres_[cell]; }

    /// sqrt(area) [m]: the one length that stands for a cell's size, in rates such as nu/width^2, in
    /// counts of cells a diameter and in tolerances. Not the gap between two faces of a stretched cell.
    double width(int cell) const { return widths_[cell]; }

    const Box& box(int cell) const { return boxes_[cell]; }

    /// Replaces `found` by all cells whose boxes overlap the query [m], each once, in rising order.
    /// Allocates only if `found` has to grow.
    void cellsOverlapping(const Box& query, std::vector<int>& found) const
    {
        bins_.overlapping(query, found);
    }

private:
    std::vector<int> offsets_{0};
    std::vector<Vector2> vertices_;
    std::vector<double> areas_;
    std::vector<Vector2> centres_;
    std::vector<double> widths_;
    std::vector<Box> boxes_;
    BoxBins bins_;
};

} // namespace chesil
