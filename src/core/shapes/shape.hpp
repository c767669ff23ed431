#pragma once

#include "core/shapes/circle.hpp"
#include "core/shapes/convexPolygon.hpp"
#include "core/shapes/ellipse.hpp"
#include "core/shapes/polyBezier.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <variant>

namespace chesil
{

/// The shapes a grain can have: the one line to lengthen for a new shape (doc/addAShape.md). A build with fewer says
/// which (tests/benchmarks/payForUse). Each offers support(direction), boundingRadius(), massProperties(), outline(),
/// typeName; its frame has the origin at the centroid.
#ifndef CHESIL_SHAPES
#define CHESIL_SHAPES Circle, Ellipse, ConvexPolygon, PolyBezier
#endif
using Shape = std::variant<CHESIL_SHAPES>;

/// What a shape in a size that is not its own was made from: the original's name and the size (diameterOf) [m].
struct ScaledFrom
{
    std::string name;
    double size = 0;
};

/// A shape under the name the user knows it by.
struct NamedShape
{
    std::string name;
    Shape shape;
    /// None for a shape of its own size.
    std::optional<ScaledFrom> scaledFrom = std::nullopt;
};

inline double boundingRadius(const Shape& shape)
{
    return std::visit([](const auto& s) { return s.boundingRadius(); }, shape);
}

/// Of a disk about the centroid that lies within the grain [m]: the largest one, or for a polybezier nearly so.
inline double innerRadius(const Shape& shape)
{
    return std::visit([](const auto& s) { return s.innerRadius(); }, shape);
}

inline MassProperties massProperties(const Shape& shape)
{
    return std::visit([](const auto& s) { return s.massProperties(); }, shape);
}

/// Of the disk of the same area [m]: a grain's size.
inline double diameterOf(const Shape& shape)
{
    return 2 * std::sqrt(massProperties(shape).area / M_PI);
}

inline Outline outline(const Shape& shape)
{
    return std::visit([](const auto& s) { return s.outline(); }, shape);
}

inline Vector2 support(const Shape& shape, const Vector2& direction)
{
    return std::visit([&](const auto& s) { return s.support(direction); }, shape);
}

/// Radius of curvature of the outline at a unit normal [m]: 0 at a corner, infinite within a straight side.
inline double curvatureRadius(const Shape& shape, const Vector2& normal)
{
    return std::visit([&](const auto& s) { return s.curvedSupport(normal).radius.value; }, shape);
}

/// Whether the outline is curved all round: no corners, no straight sides.
inline bool isSmooth(const Shape& shape)
{
    return std::visit(
        [](const auto& s)
        {
            if constexpr (std::decay_t<decltype(s)>::mayHaveStraightSides)
            {
                return s.leastRadius() > 0 && !s.hasStraightSides();
            }
            return true;
        },
        shape);
}

} // namespace chesil
