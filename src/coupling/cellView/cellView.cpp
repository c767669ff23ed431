#include "coupling/cellView/cellView.hpp"

#include "core/base/setupError.hpp"
#include "core/geometry/convexity.hpp"

#include <cmath>
#include <string>

namespace chesil
{

namespace
{

void requireOffsets(const std::vector<int>& offsets, std::size_t vertexCount)
{
    const std::string wanted =
        "offsets that rise from 0 to the number of vertices, " + std::to_string(vertexCount);
    if (offsets.empty() || offsets.front() != 0)
    {
        throw ValueError("offsets that do not begin with 0", wanted);
    }
    for (std::size_t i = 1; i < offsets.size(); ++i)
    {
        if (offsets[i] <= offsets[i - 1])
        {
            throw ValueError("cell " + std::to_string(i - 1) + " without corners", wanted);
        }
    }
    if (offsets.back() != static_cast<int>(vertexCount))
    {
        throw ValueError("offsets that end with " + std::to_string(offsets.back()), wanted);
    }
}

void requireConvexCell(int cell, const CellPolygon& polygon)
{
    try
    {
        requireConvex(std::vector<Vector2>(polygon.begin(), polygon.end()), tolerances::cellConvexity);
    }
    catch (const ValueError& error)
    {
        throw ValueError("cell " + std::to_string(cell) + " with " + error.found(),
                         "for each cell " + error.expected());
    }
}

struct AreaAndCentre
{
    double area;
    Vector2 centre;
};

/// A fan of triangles from the first corner, so that a far origin costs no digits.
AreaAndCentre areaAndCentre(const CellPolygon& polygon)
{
    double area = 0;
    Vector2 first = Vector2::Zero();
    for (int i = 1; i + 1 < polygon.size(); ++i)
    {
        const Vector2 a = polygon[i] - polygon[0];
        const Vector2 b = polygon[i + 1] - polygon[0];
        const double triangle = cross(a, b) / 2;
        area += triangle;
        first += triangle * (a + b) / 3;
    }
    return {area, polygon[0] + first / area};
}

} // namespace

CellView::CellView(std::vector<int> offsets, std::vector<Vector2> vertices)
    : offsets_(std::move(offsets)), vertices_(std::move(vertices))
{
    requireOffsets(offsets_, vertices_.size());
    const std::size_t count = offsets_.size() - 1;
    areas_.reserve(count);
    centres_.reserve(count);
    widths_.reserve(count);
    boxes_.reserve(count);
    for (int cell = 0; cell < static_cast<int>(count); ++cell)
    {
        const CellPolygon corners = polygon(cell);
        requireConvexCell(cell, corners);
        const AreaAndCentre found = areaAndCentre(corners);
        areas_.push_back(found.area);
        centres_.push_back(found.centre);
        widths_.push_back(std::sqrt(found.area));
        Box box;
        for (const Vector2& corner : corners)
        {
            box.add(corner);
        }
        boxes_.push_back(box);
    }
    bins_ = BoxBins(boxes_);
}

} // namespace chesil
