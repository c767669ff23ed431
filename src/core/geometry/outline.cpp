#include "core/geometry/outline.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

namespace
{

CubicBezier placedPiece(const CubicBezier& segment, const Pose<2>& pose)
{
    std::array<Vector2, 4> points = segment.controlPoints();
    for (Vector2& point : points)
    {
        point = pose.toWorld(point);
    }
    return CubicBezier(points);
}

EllipticArc placedPiece(const EllipticArc& arc, const Pose<2>& pose)
{
    return {pose.toWorld(arc.centre), pose.rotation.apply(arc.axisA), pose.rotation.apply(arc.axisB), arc.from, arc.to};
}

/// A chord over a parameter step h leaves the curve by at most h^2 max|B''| / 8.
int chordCount(double largestSecondDerivative, double range, double tolerance)
{
    // Of memory only: reached at 1e-12 of the size.
    constexpr int most = 1000000;
    const double count = range * std::sqrt(largestSecondDerivative / (8 * tolerance));
    return std::clamp(static_cast<int>(std::ceil(count)), 1, most);
}

void appendPoints(const CubicBezier& segment, double tolerance, std::vector<Vector2>& points)
{
    const double second = std::max(segment.secondDerivative(0).norm(), segment.secondDerivative(1).norm());
    // A straight segment at constant speed has a second derivative of rounding alone.
    const int count = chordCount(second, 1, tolerance);
    for (int i = 0; i < count; ++i)
    {
        points.push_back(segment.at(static_cast<double>(i) / count));
    }
}

void appendPoints(const EllipticArc& arc, double tolerance, std::vector<Vector2>& points)
{
    const double second = std::max(arc.axisA.norm(), arc.axisB.norm());
    const int count = chordCount(second, arc.to - arc.from, tolerance);
    for (int i = 0; i < count; ++i)
    {
        points.push_back(arc.at(arc.from + (arc.to - arc.from) * i / count));
    }
}

} // namespace

Outline placed(const Outline& outline, const Pose<2>& pose)
{
    Outline result;
    result.reserve(outline.size());
    for (const OutlinePiece& piece : outline)
    {
        result.push_back(std::visit([&](const auto& p) -> OutlinePiece { return placedPiece(p, pose); }, piece));
    }
    return result;
}

std::vector<Vector2> outlinePoints(const Outline& outline, double tolerance)
{
    std::vector<Vector2> points;
    for (const OutlinePiece& piece : outline)
    {
        std::visit([&](const auto& p) { appendPoints(p, tolerance, points); }, piece);
    }
    return points;
}

} // namespace chesil
