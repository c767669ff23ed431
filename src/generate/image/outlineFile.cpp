#include "generate/image/outlineFile.hpp"

#include "core/base/setupError.hpp"
#include "generate/image/convexHull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>

namespace chesil
{

namespace
{

bool crossesItself(const std::vector<Vector2>& vertices)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_2> points;
    points.reserve(vertices.size());
    for (const Vector2& vertex : vertices)
    {
        points.emplace_back(vertex.x(), vertex.y());
    }
    return !CGAL::is_simple_2(points.begin(), points.end(), Kernel());
}

} // namespace

std::vector<Vector2> checkedOutline(std::vector<Vector2> vertices)
{
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    while (vertices.size() > 1 && vertices.front() == vertices.back())
    {
        vertices.pop_back();
    }
    if (vertices.size() < 3)
    {
        throw ValueError("an outline of " + std::to_string(vertices.size()) + " different points",
                         "at least 3 of them");
    }
    if (crossesItself(vertices))
    {
        throw ValueError("an outline that crosses or touches itself", "a simple polygon");
    }
    // About its own first vertex, since rounding grows with the distance from the origin.
    std::vector<Vector2> local = vertices;
    for (Vector2& vertex : local)
    {
        vertex -= vertices.front();
    }
    const double area = polygonArea(local);
    if (area == 0)
    {
        throw ValueError("an outline of no area", "points that are not all on a line");
    }
    if (area < 0)
    {
        std::reverse(vertices.begin(), vertices.end());
    }
    return vertices;
}

} // namespace chesil
