#include "generate/fit/swarmFit.hpp"

#include "core/base/setupError.hpp"
#include "generate/fit/jointPlan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace chesil
{

namespace
{

/// Least length of x1 and x2 in units of the hull's size, see leastHandle in smoothOutline.cpp.
constexpr double leastLength = 1e-3;

/// In units of that: a joint this near to its neighbour's tangent line lies on it, and the segment is
/// straight.
constexpr double nothing = 1e-6;

/// Share of the way to the crossing that x1 and x2 leave: with both points on it, the direction of Q1 Q2
/// would be rounding alone.
constexpr double crossingMargin = 1e-3;

/// Chords that stand for a segment when its pixels are counted.
constexpr int chords = 24;

/// Numbers of dark pixels in runs of a row.
class DarkPixels
{
public:
    explicit DarkPixels(const Silhouette& silhouette)
        : width_(silhouette.width()), height_(silhouette.height())
    {
        for (int y = 0; y < height_; ++y)
        {
            sums_.push_back(0);
            for (int x = 0; x < width_; ++x)
            {
                sums_.push_back(sums_.back() + (silhouette.dark(x, y) ? 1 : 0));
            }
        }
    }

    /// From pixel `first` to the one before `end`.
    int count(int y, int first, int end) const
    {
        if (y < 0 || y >= height_ || end <= first)
        {
            return 0;
        }
        const int* row = sums_.data() + static_cast<std::ptrdiff_t>(y) * (width_ + 1);
        return row[std::clamp(end, 0, width_)] - row[std::clamp(first, 0, width_)];
    }

private:
    int width_;
    int height_;
    std::vector<int> sums_;
};

int firstPixel(double coordinate) { return static_cast<int>(std::ceil(coordinate - 0.5)); }

/// The pixels with their centre in a convex polygon, one run a row.
class Runs
{
public:
    template <std::size_t count>
    void set(const std::array<Vector2, count>& polygon)
    {
        double lowest = polygon[0].y();
        double highest = lowest;
        for (const Vector2& vertex : polygon)
        {
            lowest = std::min(lowest, vertex.y());
            highest = std::max(highest, vertex.y());
        }
        firstRow = firstPixel(lowest);
        constexpr double infinite = std::numeric_limits<double>::infinity();
        reaches.assign(static_cast<std::size_t>(firstPixel(highest) - firstRow), {infinite, -infinite});
        for (std::size_t i = 0; i < count; ++i)
        {
            addSide(polygon[i], polygon[(i + 1) % count]);
        }
    }

    void addSide(const Vector2& a, const Vector2& b)
    {
        const Vector2& low = a.y() < b.y() ? a : b;
        const Vector2& high = a.y() < b.y() ? b : a;
        const double slope = (high.x() - low.x()) / (high.y() - low.y());
        for (int row = firstPixel(low.y()); row < firstPixel(high.y()); ++row)
        {
            const double crossing = low.x() + slope * (row + 0.5 - low.y());
            auto& [least, most] = reaches[static_cast<std::size_t>(row - firstRow)];
            least = std::min(least, crossing);
            most = std::max(most, crossing);
        }
    }

    int firstRow = 0;
    std::vector<std::array<double, 2>> reaches;
};

/// The pixels that a segment gets wrong, as a function of x1 and x2.
class SegmentCost
{
public:
    SegmentCost(const DarkPixels& pixels, const Vector2& start, const Vector2& startTangent,
                const Vector2& end, const Vector2& endTangent)
        : pixels_(pixels), start_(start), startTangent_(startTangent), end_(end), endTangent_(endTangent)
    {
        const double sine = cross(startTangent, endTangent);
        const Vector2 chord = end - start;
        longest_ << std::max(0.0, cross(chord, endTangent) / sine),
            std::max(0.0, cross(startTangent, chord) / sine);
        runs_.set(std::array<Vector2, 3>{start, Vector2(start + longest_[0] * startTangent), end});
        for (std::size_t k = 0; k < runs_.reaches.size(); ++k)
        {
            const auto [least, most] = runs_.reaches[k];
            dark_ += pixels.count(runs_.firstRow + static_cast<int>(k), firstPixel(least), firstPixel(most));
        }
    }

    /// Up to the crossing of the tangent lines.
    const Eigen::Array2d& longest() const { return longest_; }

    CubicBezier segment(const Eigen::ArrayXd& lengths) const
    {
        return CubicBezier(
            {start_, start_ + lengths[0] * startTangent_, end_ - lengths[1] * endTangent_, end_});
    }

    double operator()(const Eigen::ArrayXd& lengths)
    {
        const CubicBezier curve = segment(lengths);
        std::array<Vector2, chords + 1> points;
        for (std::size_t k = 0; k <= chords; ++k)
        {
            points[k] = curve.at(static_cast<double>(k) / chords);
        }
        runs_.set(points);
        int wrong = dark_;
        for (std::size_t k = 0; k < runs_.reaches.size(); ++k)
        {
            const int first = firstPixel(runs_.reaches[k][0]);
            const int last = firstPixel(runs_.reaches[k][1]);
            wrong += last - first - 2 * pixels_.count(runs_.firstRow + static_cast<int>(k), first, last);
        }
        return wrong;
    }

private:
    const DarkPixels& pixels_;
    Vector2 start_, startTangent_, end_, endTangent_;
    Eigen::Array2d longest_;
    int dark_ = 0;
    Runs runs_;
};

struct Joint
{
    Vector2 point;
    Vector2 tangentBefore;
    Vector2 tangentAfter;
};

/// Of a side square to the direction, to rounding, the middle.
Vector2 supportPoint(const std::vector<Vector2>& hull, const Vector2& direction)
{
    std::size_t best = 0;
    for (std::size_t i = 1; i < hull.size(); ++i)
    {
        best = direction.dot(hull[i]) > direction.dot(hull[best]) ? i : best;
    }
    for (const std::size_t other : {(best + 1) % hull.size(), (best + hull.size() - 1) % hull.size()})
    {
        const Vector2 side = hull[other] - hull[best];
        if (std::abs(direction.dot(side)) < 1e-9 * side.norm())
        {
            return (hull[other] + hull[best]) / 2;
        }
    }
    return hull[best];
}

std::vector<Joint> jointsOf(const std::vector<Vector2>& hull, int segments)
{
    std::vector<Joint> joints;
    for (int i = 0; i < segments; ++i)
    {
        const double angle = 2 * M_PI * i / segments;
        const Vector2 normal(std::cos(angle), std::sin(angle));
        const Vector2 tangent = perpendicular(normal);
        const Vector2 point = supportPoint(hull, normal);
        if (!joints.empty() && joints.back().point == point)
        {
            joints.back().tangentAfter = tangent;
        }
        else
        {
            joints.push_back({point, tangent, tangent});
        }
    }
    if (joints.size() > 1 && joints.back().point == joints.front().point)
    {
        joints.front().tangentBefore = joints.back().tangentBefore;
        joints.pop_back();
    }
    return joints;
}

} // namespace

std::vector<CubicBezier> fitBySwarm(const Silhouette& silhouette, const std::vector<Vector2>& hull,
                                    int segments, const SwarmSettings& settings)
{
    if (segments < fewestSegments || segments > mostSegments)
    {
        throw ValueError(std::to_string(segments) + " segments",
                         std::to_string(fewestSegments) + " to " + std::to_string(mostSegments));
    }
    const DarkPixels pixels(silhouette);
    const double least = leastLength * std::hypot(silhouette.width(), silhouette.height()) / 2;
    std::vector<CubicBezier> outline;
    const std::vector<Joint> joints = jointsOf(hull, segments);
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        const Joint& start = joints[i];
        const Joint& end = joints[(i + 1) % joints.size()];
        SegmentCost cost(pixels, start.point, start.tangentAfter, end.point, end.tangentBefore);
        const Eigen::ArrayXd longest = cost.longest();
        if (longest.minCoeff() < nothing * least)
        {
            outline.push_back(CubicBezier::straight(start.point, end.point));
            continue;
        }
        const Eigen::ArrayXd upper = (1 - crossingMargin) * longest;
        outline.push_back(cost.segment(minimiseBySwarm(std::ref(cost), upper.min(least), upper, settings)));
    }
    return outline;
}

} // namespace chesil
