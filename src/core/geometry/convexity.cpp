#include "core/geometry/convexity.hpp"

#include "core/base/setupError.hpp"

#include <cmath>
#include <string>

namespace chesil
{

namespace
{

std::string atVertex(std::size_t index, const Vector2& vertex)
{
    return " at vertex " + std::to_string(index) + " (" + numberText(vertex.x()) + " " + numberText(vertex.y()) + ")";
}

} // namespace

void requireConvex(const std::vector<Vector2>& vertices, double allowedTurn)
{
    const std::string wanted = "a convex outline, counter-clockwise, with finite coordinates";
    std::vector<Vector2> edges;
    std::vector<std::size_t> edgeEnds;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        if (!vertices[i].allFinite())
        {
            throw ValueError("a coordinate that is not a number" + atVertex(i, vertices[i]), wanted);
        }
        const std::size_t next = (i + 1) % vertices.size();
        const Vector2 edge = vertices[next] - vertices[i];
        if (edge != Vector2::Zero())
        {
            edges.push_back(edge);
            edgeEnds.push_back(next);
        }
    }
    if (edges.size() < 3)
    {
        throw ValueError("fewer than three distinct vertices", wanted);
    }

    double turning = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
        const Vector2& a = edges[i];
        const Vector2& b = edges[(i + 1) % edges.size()];
        const double angle = std::atan2(cross(a, b), a.dot(b));
        if (angle < -allowedTurn)
        {
            const std::size_t vertex = edgeEnds[i];
            throw ValueError(
                "an inward turn of " + numberText(-angle) + " rad" + atVertex(vertex, vertices[vertex])
                    + " (not convex, clockwise or crossing itself)",
                wanted);
        }
        if (angle > M_PI - tolerances::convexity)
        {
            throw ValueError("a turn back on itself" + atVertex(edgeEnds[i], vertices[edgeEnds[i]]), wanted);
        }
        turning += angle;
    }
    // A convex outline turns by 2 pi; one that crosses itself without an inward turn by 4 pi or more.
    if (std::abs(turning - 2 * M_PI) > 1)
    {
        throw ValueError(
            "an outline that turns by " + numberText(turning / (2 * M_PI)) + " full turns (crossing itself)", wanted);
    }
}

} // namespace chesil
