#pragma once

#include "core/narrowphase/minkowskiDifference.hpp"

#include <array>
#include <utility>

namespace chesil
{

/// The vertices that GJK keeps, at most Dim + 1 of them.
template <int Dim>
struct Simplex
{
    std::array<SupportVertex<Dim>, Dim + 1> vertices;
    int count = 0;

    void push(const SupportVertex<Dim>& vertex) { vertices[static_cast<std::size_t>(count++)] = vertex; }
};

/// Reduces the simplex to the face nearest the origin and gives the direction from it to the origin. True
/// if the simplex holds the origin; a triangle is then counter-clockwise. The newest vertex is the last.
inline bool enclose(Simplex<2>& simplex, Vector2& direction)
{
    auto& v = simplex.vertices;
    if (simplex.count == 1)
    {
        direction = -v[0].difference;
        return false;
    }
    if (simplex.count == 2)
    {
        const Vector2 edge = v[1].difference - v[0].difference;
        direction = perpendicular(edge);
        if (direction.dot(v[0].difference) > 0)
        {
            direction = -direction;
        }
        return false;
    }

    if (cross(v[1].difference - v[0].difference, v[2].difference - v[0].difference) < 0)
    {
        std::swap(v[0], v[1]);
    }
    // The edge (0, 1) was passed on the way to vertex 2: only the two edges at vertex 2 can see the origin.
    const Vector2 outwardOfEdge12 = -perpendicular(v[2].difference - v[1].difference);
    const Vector2 outwardOfEdge20 = -perpendicular(v[0].difference - v[2].difference);
    if (outwardOfEdge12.dot(v[2].difference) < 0)
    {
        v[0] = v[1];
        v[1] = v[2];
        simplex.count = 2;
        direction = outwardOfEdge12;
        return false;
    }
    if (outwardOfEdge20.dot(v[2].difference) < 0)
    {
        v[1] = v[2];
        simplex.count = 2;
        direction = outwardOfEdge20;
        return false;
    }
    return true;
}

} // namespace chesil
