#include "core/shapes/polyBezier.hpp"

#include "core/base/setupError.hpp"
#include "core/base/tolerances.hpp"
#include "core/geometry/convexity.hpp"
#include "core/shapes/centring.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

namespace
{

void requireClosed(const std::vector<CubicBezier>& segments)
{
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
        const std::size_t next = (i + 1) % segments.size();
        if (segments[i].end() != segments[next].start())
        {
            throw ValueError(
                "segment " + std::to_string(i) + " ends " + numberText((segments[i].end() - segments[next].start()).norm())
                    + " m away from the start of segment " + std::to_string(next),
                "segments joined end to start");
        }
        if (segments[i].startTangent() == Vector2::Zero())
        {
            throw ValueError("segment " + std::to_string(i) + " with four equal control points", "segments of a positive length");
        }
    }
}

/// Two roots in (0, 1) would be beyond the closed form of the support point.
void requireHalfTurnAtMost(const std::vector<CubicBezier>& segments)
{
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
        const auto& points = segments[i].controlPoints();
        Vector2 tangent = segments[i].startTangent();
        double turn = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Vector2 edge = points[k + 1] - points[k];
            if (edge != Vector2::Zero())
            {
                turn += std::atan2(cross(tangent, edge), tangent.dot(edge));
                tangent = edge;
            }
        }
        if (turn > M_PI + tolerances::convexity)
        {
            throw ValueError(
                "segment " + std::to_string(i) + " turns by " + numberText(turn * 180 / M_PI) + " degrees",
                "segments that turn by at most 180 degrees (split this one)");
        }
    }
}

std::vector<Vector2> controlPolygon(const std::vector<CubicBezier>& segments)
{
    std::vector<Vector2> vertices;
    for (const CubicBezier& segment : segments)
    {
        const auto& points = segment.controlPoints();
        vertices.insert(vertices.end(), points.begin(), points.begin() + 3);
    }
    return vertices;
}

/// A bound on the distance of the segment from the origin, since the broad phase trusts it: the furthest control
/// point of its parts, which leave the curve by the square of their length only.
double furthestPoint(const CubicBezier& segment)
{
    constexpr int parts = 16;
    double furthest = 0;
    for (int i = 0; i < parts; ++i)
    {
        const CubicBezier part = segment.part(static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts);
        for (const Vector2& point : part.controlPoints())
        {
            furthest = std::max(furthest, point.norm());
        }
    }
    return furthest;
}

} // namespace

PolyBezier::PolyBezier(const std::vector<CubicBezier>& segments)
{
    if (segments.size() < 2)
    {
        throw ValueError(std::to_string(segments.size()) + " segments", "at least 2");
    }
    requireClosed(segments);
    requireConvex(controlPolygon(segments));
    requireHalfTurnAtMost(segments);

    CentredBoundary boundary = centred(segments);
    segments_ = std::move(boundary.segments);
    givenCentroid_ = boundary.givenCentroid;
    mass_ = boundary.mass;

    std::vector<Vector2> starts;
    for (const CubicBezier& segment : segments_)
    {
        starts.push_back(-perpendicular(segment.startTangent()));
        boundingRadius_ = std::max(boundingRadius_, furthestPoint(segment));
    }
    normals_ = NormalTable(starts);
}

double PolyBezier::largestJointAngle() const
{
    double largest = 0;
    for (std::size_t i = 0; i < segments_.size(); ++i)
    {
        const Vector2 before = segments_[i].endTangent();
        const Vector2 after = segments_[(i + 1) % segments_.size()].startTangent();
        largest = std::max(largest, std::abs(std::atan2(cross(before, after), before.dot(after))));
    }
    return largest;
}

} // namespace chesil
