#pragma once

#include "benchmarks/common/benchmark.hpp"
#include "core/shapes/scaledShape.hpp"
#include "unit/randomGrain.hpp"

#include <vector>

/// The grains that all codes are given: as disks, as polybeziers, and as polygons that stand for the latter.
namespace chesil::benchmark
{

constexpr std::uint64_t templateSeed = 20240715;
/// Diameters, or those of disks of the same area, are spread evenly from 0.8 to 1.2 [m]; all grains share
/// these templates.
constexpr int templates = 41;
constexpr double smallestDiameter = 0.8;
constexpr double largestDiameter = 1.2;

inline double templateDiameter(int number)
{
    return smallestDiameter + (largestDiameter - smallestDiameter) * number / (templates - 1);
}

inline double templateArea(int number)
{
    return M_PI / 4 * templateDiameter(number) * templateDiameter(number);
}

inline std::vector<NamedShape> diskTemplates()
{
    std::vector<NamedShape> shapes;
    for (int i = 0; i < templates; ++i)
    {
        shapes.push_back({text("disk%d", i), Circle(templateDiameter(i) / 2)});
    }
    return shapes;
}

/// Of 10 segments each, none straight.
inline std::vector<NamedShape> polyBezierTemplates()
{
    test::RandomSource random(templateSeed);
    std::vector<NamedShape> shapes;
    for (int i = 0; i < templates; ++i)
    {
        const Shape shape = test::randomPolyBezier(test::RandomGrainOptions(), random);
        shapes.push_back(
            {text("grain%d", i), scaled(shape, std::sqrt(templateArea(i) / massProperties(shape).area))});
    }
    return shapes;
}

/// A polygon rounded by `radius` [m], as peers have them: vertices of its core about the grain's centroid.
struct RoundedPolygon
{
    std::vector<Vector2> core;
    double radius = 0;
};

/// Through 6, 7 or 8 support points of the polybezier, and of its area with the rounding: that of the core
/// grows as the square of its scale, that of the rim with its perimeter.
inline RoundedPolygon roundedPolygonOf(int number, const Shape& grain, double radius)
{
    const int sides = 6 + number % 3;
    std::vector<Vector2> points;
    for (int k = 0; k < sides; ++k)
    {
        const double angle = 2 * M_PI * k / sides;
        points.push_back(support(grain, Vector2(std::cos(angle), std::sin(angle))));
    }
    RoundedPolygon result{ConvexPolygon(points).vertices(), radius};
    double perimeter = 0;
    for (std::size_t k = 0; k < result.core.size(); ++k)
    {
        perimeter += (result.core[(k + 1) % result.core.size()] - result.core[k]).norm();
    }
    const double area = massProperties(Shape(ConvexPolygon(points))).area;
    const double missing = M_PI * radius * radius - massProperties(grain).area;
    const double half = perimeter * radius / (2 * area);
    const double scale = std::sqrt(half * half - missing / area) - half;
    for (Vector2& vertex : result.core)
    {
        vertex *= scale;
    }
    return result;
}

/// Radius of the rounding that LAMMPS's polygons must have [m].
constexpr double lammpsRounding = 0.05;

/// The polygon with sharp corners around a rounded one.
inline ConvexPolygon mitred(const RoundedPolygon& polygon)
{
    const std::size_t sides = polygon.core.size();
    const auto normalAfter = [&](std::size_t vertex)
    {
        const Vector2 side = polygon.core[(vertex + 1) % sides] - polygon.core[vertex % sides];
        return Vector2(Vector2(side.y(), -side.x()).normalized());
    };
    std::vector<Vector2> vertices;
    for (std::size_t k = 0; k < sides; ++k)
    {
        const Vector2 before = normalAfter(k + sides - 1);
        const Vector2 after = normalAfter(k);
        vertices.push_back(polygon.core[k] + polygon.radius / (1 + before.dot(after)) * (before + after));
    }
    return ConvexPolygon(vertices);
}

/// LAMMPS's polygons with sharp corners: packed like this by our engine, LAMMPS begins without overlaps, at
/// which its arrays of contacts would overflow.
inline std::vector<NamedShape> polygonTemplates()
{
    std::vector<NamedShape> shapes;
    for (const NamedShape& grain : polyBezierTemplates())
    {
        const int number = static_cast<int>(shapes.size());
        shapes.push_back(
            {text("polygon%d", number), mitred(roundedPolygonOf(number, grain.shape, lammpsRounding))});
    }
    return shapes;
}

} // namespace chesil::benchmark
