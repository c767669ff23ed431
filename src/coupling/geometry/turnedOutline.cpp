#include "coupling/geometry/turnedOutline.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

namespace
{

CubicBezier turned(const CubicBezier& segment, const Rotation<2>& rotation)
{
    std::array<Vector2, 4> points = segment.controlPoints();
    for (Vector2& point : points)
    {
        point = rotation.apply(point);
    }
    return CubicBezier(points);
}

EllipticArc turned(const EllipticArc& arc, const Rotation<2>& rotation)
{
    return {rotation.apply(arc.centre), rotation.apply(arc.axisA), rotation.apply(arc.axisB), arc.from,
            arc.to};
}

BoundaryPiece wholePiece(const CubicBezier& segment, int curve)
{
    return {curve, 0, 1, segment.start(), segment.end()};
}

BoundaryPiece wholePiece(const EllipticArc& arc, int curve)
{
    return {curve, arc.from, arc.to, arc.at(arc.from), arc.at(arc.to)};
}

Box boxOf(const CubicBezier& segment)
{
    Box box;
    for (const Vector2& point : segment.controlPoints())
    {
        box.add(point);
    }
    return box;
}

/// Of the whole ellipse.
Box boxOf(const EllipticArc& arc)
{
    const Vector2 reach(std::hypot(arc.axisA.x(), arc.axisB.x()), std::hypot(arc.axisA.y(), arc.axisB.y()));
    return {arc.centre - reach, arc.centre + reach};
}

double furthest(const CubicBezier& segment)
{
    double distance = 0;
    for (const Vector2& point : segment.controlPoints())
    {
        distance = std::max(distance, point.norm());
    }
    return distance;
}

double furthest(const EllipticArc& arc)
{
    return arc.centre.norm() + std::max(arc.axisA.norm(), arc.axisB.norm());
}

} // namespace

void TurnedOutline::set(const Outline& outline, const Rotation<2>& rotation)
{
    curves_.clear();
    chain_.clear();
    box_ = Box();
    outerRadius_ = 0;
    const auto add = [&](const auto& given)
    {
        const auto piece = turned(given, rotation);
        chain_.push_back(wholePiece(piece, static_cast<int>(curves_.size())));
        box_.add(boxOf(piece));
        outerRadius_ = std::max(outerRadius_, furthest(piece));
        curves_.push_back(piece);
    };
    for (const OutlinePiece& piece : outline)
    {
        std::visit(add, piece);
    }
    for (std::size_t i = 0; i < chain_.size(); ++i)
    {
        chain_[i].end = chain_[(i + 1) % chain_.size()].start;
    }
}

} // namespace chesil
