#include "core/shapes/convexPolygon.hpp"

#include "core/base/setupError.hpp"
#include "core/geometry/convexity.hpp"
#include "core/shapes/centring.hpp"

#include <algorithm>

namespace chesil
{

namespace
{

std::vector<Vector2> withoutRepeats(const std::vector<Vector2>& vertices)
{
    std::vector<Vector2> kept;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        if (vertices[i] != vertices[(i + 1) % vertices.size()])
        {
            kept.push_back(vertices[i]);
        }
    }
    return kept;
}

std::vector<CubicBezier> edgesOf(const std::vector<Vector2>& vertices)
{
    std::vector<CubicBezier> edges;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        edges.push_back(CubicBezier::straight(vertices[i], vertices[(i + 1) % vertices.size()]));
    }
    return edges;
}

} // namespace

ConvexPolygon::ConvexPolygon(const std::vector<Vector2>& vertices)
{
    requireConvex(vertices);
    const CentredBoundary boundary = centred(edgesOf(withoutRepeats(vertices)));
    givenCentroid_ = boundary.givenCentroid;
    mass_ = boundary.mass;
    for (const CubicBezier& edge : boundary.segments)
    {
        vertices_.push_back(edge.start());
        boundingRadius_ = std::max(boundingRadius_, edge.start().norm());
    }

    // Vertex i is the support point from the normal of the edge before it to that of the edge after it.
    std::vector<Vector2> starts;
    for (std::size_t i = 0; i < vertices_.size(); ++i)
    {
        const Vector2& before = vertices_[(i + vertices_.size() - 1) % vertices_.size()];
        starts.push_back(-perpendicular(vertices_[i] - before));
    }
    normals_ = NormalTable(starts);
}

Outline ConvexPolygon::outline() const
{
    const std::vector<CubicBezier> edges = edgesOf(vertices_);
    return Outline(edges.begin(), edges.end());
}

} // namespace chesil
