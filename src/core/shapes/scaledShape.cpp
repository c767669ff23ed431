#include "core/shapes/scaledShape.hpp"

#include "core/base/setupError.hpp"

#include <vector>

namespace chesil
{

namespace
{

Circle scaledBy(double scale, const Circle& circle) { return Circle(scale * circle.radius()); }

Ellipse scaledBy(double scale, const Ellipse& ellipse)
{
    return Ellipse(scale * ellipse.a(), scale * ellipse.b());
}

ConvexPolygon scaledBy(double scale, const ConvexPolygon& polygon)
{
    std::vector<Vector2> vertices;
    for (const Vector2& vertex : polygon.vertices())
    {
        vertices.push_back(scale * vertex);
    }
    return ConvexPolygon(vertices);
}

PolyBezier scaledBy(double scale, const PolyBezier& outline)
{
    std::vector<CubicBezier> segments;
    for (const CubicBezier& segment : outline.segments())
    {
        segments.push_back(segment.transformed(Vector2::Zero(), 1, 0, scale));
    }
    return PolyBezier(segments);
}

} // namespace

Shape scaled(const Shape& shape, double scale)
{
    // A negative one would turn polygons by 180 degrees instead of being refused.
    if (!(scale > 0))
    {
        throw ValueError(numberText(scale), "a scale > 0");
    }
    return std::visit([&](const auto& original) { return Shape(scaledBy(scale, original)); }, shape);
}

NamedShape ofSize(const NamedShape& original, double size)
{
    return {original.name + " of size " + numberText(size) + " m",
            scaled(original.shape, size / diameterOf(original.shape)), ScaledFrom{original.name, size}};
}

} // namespace chesil
