#include "core/shapes/convexPolygon.hpp"

#include "core/base/sizeRange.hpp"
#include "core/base/tolerances.hpp"
#include "core/geometry/convexity.hpp"
#include "core/shapes/centring.hpp"

#include <algorithm>
#include <cmath>

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

    requireSize(boundingRadius_, "an outline with a bounding radius");
    innerRadius_ = boundingRadius_;
    for (std::size_t i = 0; i < vertices_.size(); ++i)
    {
        const Vector2& end = vertices_[(i + 1) % vertices_.size()];
        sides_.push_back({-perpendicular(end - vertices_[i]).normalized(), vertices_[i], end});
        innerRadius_ = std::min(innerRadius_, sides_.back().normal.dot(vertices_[i]));
    }

    // Vertex i is the support point from the normal of the edge before it to that of the edge after it.
    std::vector<Vector2> starts;
    for (std::size_t i = 0; i < vertices_.size(); ++i)
    {
        starts.push_back(sides_[(i + vertices_.size() - 1) % vertices_.size()].normal);
    }
    normals_ = NormalTable(starts);
}

const StraightSide* ConvexPolygon::straightSideFacing(const Vector2& normal) const
{
    const std::size_t vertex = supportVertex(normal);
    const StraightSide& before = sides_[vertex == 0 ? sides_.size() - 1 : vertex - 1];
    const StraightSide& after = sides_[vertex];
    return before.normal.dot(normal) > after.normal.dot(normal) ? &before : &after;
}

const StraightSide* ConvexPolygon::straightSideBetween(const Vector2& from, const Vector2& to) const
{
    const bool counterClockwise = cross(from, to) > 0;
    const std::size_t size = sides_.size();
    std::size_t first = normals_.find(counterClockwise ? from : to);
    std::size_t count = normals_.find(counterClockwise ? to : from) + size - first;
    count = count >= size ? count - size : count;
    if (count == 0)
    {
        return nullptr;
    }
    first += count / 2;
    const StraightSide& side = sides_[first >= size ? first - size : first];
    const bool apart = std::abs(cross(from, side.normal)) > tolerances::sameNormal
        && std::abs(cross(to, side.normal)) > tolerances::sameNormal;
    return apart ? &side : nullptr;
}

Outline ConvexPolygon::outline() const
{
    const std::vector<CubicBezier> edges = edgesOf(vertices_);
    return Outline(edges.begin(), edges.end());
}

} // namespace chesil
