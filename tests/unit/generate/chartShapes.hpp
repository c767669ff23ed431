#pragma once

#include "unit/generate/drawnShapes.hpp"

#include <algorithm>
#include <limits>

/// Convex shapes over the axes of the chart of Krumbein & Sloss (1951), of our own making; those that
/// tutorials/generate/chart/drawChart draws.
namespace chesil::test
{

/// A convex polygon whose corners are all rounded to one radius: the points within `radius` of its `core`,
/// the polygon with its sides moved inward by the radius.
struct RoundedPolygon
{
    std::vector<Vector2> core;
    double radius;

    bool operator()(const Vector2& point) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        bool inCore = core.size() > 2;
        for (std::size_t i = 0; i < core.size(); ++i)
        {
            const Vector2 edge = core[(i + 1) % core.size()] - core[i];
            const Vector2 local = point - core[i];
            inCore = inCore && cross(edge, local) >= 0;
            const double along = std::clamp(local.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (local - along * edge).norm());
        }
        return inCore || nearest <= radius;
    }
};

/// The part of a convex polygon that lies further inside than `distance`; empty if there is none.
inline std::vector<Vector2> movedInward(const std::vector<Vector2>& polygon, double distance)
{
    std::vector<Vector2> kept = polygon;
    for (std::size_t side = 0; side < polygon.size(); ++side)
    {
        const Vector2 edge = (polygon[(side + 1) % polygon.size()] - polygon[side]).normalized();
        std::vector<Vector2> clipped;
        for (std::size_t i = 0; i < kept.size(); ++i)
        {
            const Vector2& a = kept[i];
            const Vector2& b = kept[(i + 1) % kept.size()];
            const double insideA = cross(edge, a - polygon[side]) - distance;
            const double insideB = cross(edge, b - polygon[side]) - distance;
            if (insideA >= 0)
            {
                clipped.push_back(a);
            }
            if ((insideA > 0 && insideB < 0) || (insideA < 0 && insideB > 0))
            {
                clipped.push_back(a + insideA / (insideA - insideB) * (b - a));
            }
        }
        kept = std::move(clipped);
    }
    return kept;
}

inline double inscribedRadius(const std::vector<Vector2>& polygon)
{
    double low = 0;
    double high = 1;
    while (!movedInward(polygon, high).empty())
    {
        high *= 2;
    }
    for (int halving = 0; halving < 60; ++halving)
    {
        const double middle = (low + high) / 2;
        (movedInward(polygon, middle).empty() ? high : low) = middle;
    }
    return low;
}

/// Extent along x and y of the rounded polygon.
inline Vector2 extent(const RoundedPolygon& shape)
{
    Vector2 low = shape.core.front();
    Vector2 high = low;
    for (const Vector2& vertex : shape.core)
    {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    return high - low + Vector2::Constant(2 * shape.radius);
}

/// A shape of the chart, `across` [pixel] long, in a box with a margin of two pixels: a heptagon with uneven
/// corners, each rounded by `roundness` times the radius of its inscribed circle (Wadell's roundness is then
/// just that), squeezed until breadth over length is `sphericity`.
inline RoundedPolygon chartShape(double sphericity, double roundness, double across)
{
    const std::vector<double> degrees{8, 52, 118, 165, 214, 270, 322};
    const std::vector<double> reach{1, 0.92, 0.97, 0.94, 1, 0.9, 0.96};
    const auto squeezed = [&](double aspect)
    {
        std::vector<Vector2> polygon;
        for (std::size_t i = 0; i < degrees.size(); ++i)
        {
            const double angle = degrees[i] * M_PI / 180;
            polygon.push_back(reach[i] * Vector2(std::cos(angle), aspect * std::sin(angle)));
        }
        const double radius = roundness * inscribedRadius(polygon);
        return RoundedPolygon{movedInward(polygon, radius), radius};
    };
    double low = 0.1;
    double high = 3;
    for (int halving = 0; halving < 50; ++halving)
    {
        const double middle = (low + high) / 2;
        const Vector2 size = extent(squeezed(middle));
        (size.y() > sphericity * size.x() ? high : low) = middle;
    }
    RoundedPolygon shape = squeezed(low);
    const double scale = across / extent(shape).x();
    Vector2 corner = shape.core.front();
    for (const Vector2& vertex : shape.core)
    {
        corner = corner.cwiseMin(vertex);
    }
    for (Vector2& vertex : shape.core)
    {
        vertex = scale * (vertex - corner + Vector2::Constant(shape.radius)) + Vector2(2.25, 2.25);
    }
    shape.radius *= scale;
    return shape;
}

inline Silhouette drawnChartShape(double sphericity, double roundness, double across = 400)
{
    const RoundedPolygon shape = chartShape(sphericity, roundness, across);
    const Vector2 size = extent(shape) + Vector2(5, 5);
    return drawn(static_cast<int>(size.x()), static_cast<int>(size.y()), shape);
}

inline const std::vector<double>& chartSphericities()
{
    static const std::vector<double> values{0.9, 0.7, 0.5, 0.3};
    return values;
}

inline const std::vector<double>& chartRoundnesses()
{
    static const std::vector<double> values{0.1, 0.3, 0.5, 0.7, 0.9};
    return values;
}

} // namespace chesil::test
