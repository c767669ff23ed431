#pragma once

#include "core/shapes/convexPolygon.hpp"
#include "core/shapes/polyBezier.hpp"

#include <cmath>
#include <vector>

/// Boundaries whose properties are known by formula.
namespace chesil::test
{

/// The cubic segment nearest a quarter or less of a circle: ends and tangents exact, middle on the circle.
/// The radius is off by about (2/27) (angle/4)^6 of itself: 2.7e-4 for a quarter, 1e-9 for a 32nd.
inline CubicBezier circularSegment(const Vector2& centre, double radius, double from, double to)
{
    const double reach = radius * 4.0 / 3.0 * std::tan((to - from) / 4);
    const Vector2 normal0(std::cos(from), std::sin(from));
    const Vector2 normal1(std::cos(to), std::sin(to));
    const Vector2 start = centre + radius * normal0;
    const Vector2 end = centre + radius * normal1;
    return CubicBezier(
        {start, start + reach * perpendicular(normal0), end - reach * perpendicular(normal1), end});
}

/// Joins each segment to the next one's start, to the bit.
inline std::vector<CubicBezier> joined(const std::vector<CubicBezier>& segments)
{
    std::vector<CubicBezier> result;
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
        auto points = segments[i].controlPoints();
        points[3] = segments[(i + 1) % segments.size()].start();
        result.emplace_back(points);
    }
    return result;
}

/// An ellipse of half-axes a, b [m] in `count` segments.
inline std::vector<CubicBezier> ellipseSegments(int count, double a, double b,
                                                const Vector2& centre = Vector2::Zero())
{
    std::vector<CubicBezier> segments;
    for (int i = 0; i < count; ++i)
    {
        auto points = circularSegment(Vector2::Zero(), 1, 2 * M_PI * i / count, 2 * M_PI * (i + 1) / count)
                          .controlPoints();
        for (Vector2& point : points)
        {
            point = centre + Vector2(a * point.x(), b * point.y());
        }
        segments.emplace_back(points);
    }
    return joined(segments);
}

inline std::vector<CubicBezier> polygonSegments(const std::vector<Vector2>& vertices)
{
    std::vector<CubicBezier> segments;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        segments.push_back(CubicBezier::straight(vertices[i], vertices[(i + 1) % vertices.size()]));
    }
    return joined(segments);
}

inline std::vector<Vector2> rectangleVertices(double width, double height,
                                              const Vector2& centre = Vector2::Zero())
{
    const Vector2 half(width / 2, height / 2);
    return {centre - half, centre + Vector2(half.x(), -half.y()), centre + half,
            centre + Vector2(-half.x(), half.y())};
}

inline ConvexPolygon rectangle(double width, double height)
{
    return ConvexPolygon(rectangleVertices(width, height));
}

/// A square of the given side with corners rounded by `radius` < side/2.
inline PolyBezier roundedSquare(double side, double radius)
{
    const double reach = side / 2 - radius;
    const std::vector<Vector2> centres{{reach, reach}, {-reach, reach}, {-reach, -reach}, {reach, -reach}};
    std::vector<CubicBezier> arcs;
    for (int i = 0; i < 4; ++i)
    {
        arcs.push_back(
            circularSegment(centres[static_cast<std::size_t>(i)], radius, i * M_PI / 2, (i + 1) * M_PI / 2));
    }
    std::vector<CubicBezier> segments;
    for (std::size_t i = 0; i < 4; ++i)
    {
        segments.push_back(arcs[i]);
        segments.push_back(CubicBezier::straight(arcs[i].end(), arcs[(i + 1) % 4].start()));
    }
    return PolyBezier(joined(segments));
}

} // namespace chesil::test
