#include "coupling/geometry/inscribedPolygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

/// Edges to a curve: a chord of a third of a segment, or of 15 degrees of an arc, leaves the outline by
/// about 1 % of the radius. More would find a few more cells and make each test dearer.
constexpr int edgesPerSegment = 3;
constexpr double anglePerEdge = M_PI / 12;

template <typename Visit>
void forEachChord(const CubicBezier& segment, const Visit& visit)
{
    Vector2 last = segment.start();
    for (int i = 1; i <= edgesPerSegment; ++i)
    {
        const Vector2 next =
            i < edgesPerSegment ? segment.at(static_cast<double>(i) / edgesPerSegment) : segment.end();
        visit(last, next);
        last = next;
    }
}

template <typename Visit>
void forEachChord(const EllipticArc& arc, const Visit& visit)
{
    const int count = std::max(1, static_cast<int>(std::ceil((arc.to - arc.from) / anglePerEdge)));
    Vector2 last = arc.at(arc.from);
    for (int i = 1; i <= count; ++i)
    {
        const Vector2 next = arc.at(arc.from + (arc.to - arc.from) * i / count);
        visit(last, next);
        last = next;
    }
}

} // namespace

void InscribedPolygon::set(const Outline& curves)
{
    edges_.clear();
    innerRadius_ = std::numeric_limits<double>::infinity();
    const auto add = [this](const Vector2& a, const Vector2& b)
    {
        if (a == b)
        {
            return;
        }
        const Vector2 normal = perpendicular(b - a).normalized();
        const double offset = normal.dot(a);
        edges_.push_back({normal, offset});
        innerRadius_ = std::min(innerRadius_, std::max(0.0, -offset));
    };
    for (const OutlinePiece& curve : curves)
    {
        std::visit([&](const auto& c) { forEachChord(c, add); }, curve);
    }
}

bool InscribedPolygon::contains(const std::vector<Vector2>& points) const
{
    double furthest = 0;
    for (const Vector2& point : points)
    {
        furthest = std::max(furthest, point.squaredNorm());
    }
    if (furthest <= innerRadius_ * innerRadius_)
    {
        return true;
    }
    return std::all_of(points.begin(), points.end(),
                       [this](const Vector2& point)
                       {
                           return std::all_of(edges_.begin(), edges_.end(),
                                              [&](const Edge& edge)
                                              { return edge.normal.dot(point) >= edge.offset; });
                       });
}

} // namespace chesil
