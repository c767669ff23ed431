#include "core/shapes/polyBezier.hpp"

#include "core/base/setupError.hpp"
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

/// Furthest point from the origin: on each segment |B(t)| is sampled and the best sample refined.
/// The bound is what the broad phase trusts, hence the control polygon's bound closes any gap.
double furthestPoint(const CubicBezier& segment)
{
    constexpr int samples = 16;
    double furthest = 0;
    for (int i = 0; i <= samples; ++i)
    {
        furthest = std::max(furthest, segment.at(static_cast<double>(i) / samples).norm());
    }
    // Between two samples |B| rises by at most half the step times the largest speed; the control edges
    // bound the speed.
    double speed = 0;
    const auto& points = segment.controlPoints();
    for (int i = 0; i < 3; ++i)
    {
        speed = std::max(speed, 3 * (points[i + 1] - points[i]).norm());
    }
    double controlBound = 0;
    for (const Vector2& point : points)
    {
        controlBound = std::max(controlBound, point.norm());
    }
    return std::min(controlBound, furthest + speed / (2 * samples));
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
