#pragma once

#include "core/shapes/shape.hpp"
#include "unit/preciseCurve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// Support points of the shapes in long double, by other formulas than the shapes' own.
namespace chesil::test
{

inline PrecisePoint operator+(const PrecisePoint& a, const PrecisePoint& b) { return {a.x + b.x, a.y + b.y}; }
inline PrecisePoint operator-(const PrecisePoint& a, const PrecisePoint& b) { return {a.x - b.x, a.y - b.y}; }
inline PrecisePoint operator*(Real s, const PrecisePoint& a) { return {s * a.x, s * a.y}; }
inline Real preciseDot(const PrecisePoint& a, const PrecisePoint& b) { return a.x * b.x + a.y * b.y; }
inline Real preciseCross(const PrecisePoint& a, const PrecisePoint& b) { return a.x * b.y - a.y * b.x; }
inline Real preciseNorm(const PrecisePoint& a) { return std::sqrt(preciseDot(a, a)); }
inline PrecisePoint preciseUnit(const PrecisePoint& a) { return (1 / preciseNorm(a)) * a; }
inline PrecisePoint precise(const Vector2& a) { return {a.x(), a.y()}; }

/// A shape as the sum of a disk about its centre and a convex rest: the disk's share of the height is the
/// same in all directions, which leaves a search over the angle of near-circular shapes little to do. Any
/// radius up to the least radius of curvature will do: a circle's is its own; an ellipse's min(a^2/b, b^2/a);
/// a polybezier's without corners the least one found, with a margin; of others nothing.
class PreciseShape
{
public:
    explicit PreciseShape(const Shape& shape)
    {
        std::visit([this](const auto& s) { take(s); }, shape);
    }

    /// Radius of the disk [m].
    Real disk() const { return disk_; }

    /// The rest's furthest point along a direction of any length > 0 [m].
    PrecisePoint restSupport(const PrecisePoint& direction) const
    {
        if (!segments_.empty())
        {
            const PrecisePoint unit = preciseUnit(direction);
            return onSegments(unit) - disk_ * unit;
        }
        if (!vertices_.empty())
        {
            return onVertices(direction);
        }
        const PrecisePoint stretched{a_ * direction.x, b_ * direction.y};
        const Real length = preciseNorm(stretched);
        return length > 0 ? PrecisePoint{a_ * stretched.x / length, b_ * stretched.y / length} -
                                (disk_ / preciseNorm(direction)) * direction
                          : PrecisePoint{};
    }

private:
    struct Segment
    {
        PrecisePoint points[4];
    };

    void take(const Circle& circle) { disk_ = circle.radius(); }

    void take(const Ellipse& ellipse)
    {
        a_ = ellipse.a();
        b_ = ellipse.b();
        disk_ = std::min(a_ * a_ / b_, b_ * b_ / a_);
    }

    void take(const ConvexPolygon& polygon)
    {
        for (const Vector2& vertex : polygon.vertices())
        {
            vertices_.push_back(precise(vertex));
        }
    }

    void take(const PolyBezier& grain)
    {
        for (const CubicBezier& segment : grain.segments())
        {
            const auto& points = segment.controlPoints();
            segments_.push_back(
                {{precise(points[0]), precise(points[1]), precise(points[2]), precise(points[3])}});
            rough_.insert(rough_.end(), points.begin(), points.end());
            for (const Vector2& point : points)
            {
                slack_ = std::max(slack_, 8 * std::numeric_limits<double>::epsilon() * point.norm());
            }
        }
        disk_ = leastCurvatureRadius(grain);
    }

    /// Of a smooth outline. Curvature is sampled; in between it exceeds a sample by less than that one's
    /// steps to its neighbours. Joints that turn by 1e-9 rad would make the heights wrong by the square of
    /// that only.
    static Real leastCurvatureRadius(const PolyBezier& grain)
    {
        constexpr int samples = 256;
        Real largest = 0;
        for (const CubicBezier& segment : grain.segments())
        {
            std::vector<Real> curvature;
            for (int i = 0; i <= samples; ++i)
            {
                curvature.push_back(curvatureAt(segment, Real(i) / samples));
            }
            for (std::size_t i = 0; i <= samples; ++i)
            {
                const Real before = i > 0 ? std::abs(curvature[i] - curvature[i - 1]) : 0;
                const Real after = i < samples ? std::abs(curvature[i + 1] - curvature[i]) : 0;
                const Real bound = curvature[i] + before + after;
                largest =
                    std::max(largest, std::isfinite(bound) ? bound : std::numeric_limits<Real>::infinity());
            }
        }
        return grain.largestJointAngle() < 1e-9 ? 1 / largest : 0;
    }

    static Real curvatureAt(const CubicBezier& segment, Real t)
    {
        const PrecisePoint first = preciseDerivative(segment, t);
        const PrecisePoint edges[3] = {
            precise(segment.controlPoints()[1]) - precise(segment.controlPoints()[0]),
            precise(segment.controlPoints()[2]) - precise(segment.controlPoints()[1]),
            precise(segment.controlPoints()[3]) - precise(segment.controlPoints()[2])};
        const PrecisePoint second = 6 * ((1 - t) * (edges[1] - edges[0]) + t * (edges[2] - edges[1]));
        return preciseCross(first, second) / std::pow(preciseNorm(first), Real(3));
    }

    PrecisePoint onVertices(const PrecisePoint& direction) const
    {
        return *std::max_element(vertices_.begin(), vertices_.end(),
                                 [&](const PrecisePoint& p, const PrecisePoint& q)
                                 { return preciseDot(direction, p) < preciseDot(direction, q); });
    }

    /// Solves each segment whose control points reach as far as the furthest joint. The control points are
    /// compared in double, with `slack_` for the rounding.
    PrecisePoint onSegments(const PrecisePoint& unit) const
    {
        const Vector2 roughUnit(static_cast<double>(unit.x), static_cast<double>(unit.y));
        double joint = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < rough_.size(); i += 4)
        {
            joint = std::max(joint, roughUnit.dot(rough_[i]));
        }
        Real highest = -std::numeric_limits<Real>::infinity();
        PrecisePoint best;
        for (std::size_t i = 0; i < segments_.size(); ++i)
        {
            const Vector2* points = &rough_[4 * i];
            const double reach = std::max(std::max(roughUnit.dot(points[0]), roughUnit.dot(points[1])),
                                          std::max(roughUnit.dot(points[2]), roughUnit.dot(points[3])));
            if (reach >= joint - slack_)
            {
                onSegment(segments_[i], unit, highest, best);
            }
        }
        return best;
    }

    /// The ends, and where the derivative of the height vanishes: a t^2 + 2 b t + c = 0.
    static void onSegment(const Segment& segment, const PrecisePoint& unit, Real& highest, PrecisePoint& best)
    {
        const auto consider = [&](const PrecisePoint& point)
        {
            const Real height = preciseDot(unit, point);
            if (height > highest)
            {
                highest = height;
                best = point;
            }
        };
        const PrecisePoint* p = segment.points;
        consider(p[0]);
        consider(p[3]);
        const Real rise0 = preciseDot(unit, p[1] - p[0]);
        const Real rise1 = preciseDot(unit, p[2] - p[1]);
        const Real rise2 = preciseDot(unit, p[3] - p[2]);
        const Real a = rise0 - 2 * rise1 + rise2;
        const Real b = rise1 - rise0;
        const Real c = rise0;
        const Real discriminant = b * b - a * c;
        if (discriminant >= 0)
        {
            const Real q = -(b + std::copysign(std::sqrt(discriminant), b));
            for (const Real t : {q / a, c / q})
            {
                if (t > 0 && t < 1)
                {
                    const Real s = 1 - t;
                    consider((s * s * s) * p[0] + (3 * s * s * t) * p[1] + (3 * s * t * t) * p[2] +
                             (t * t * t) * p[3]);
                }
            }
        }
    }

    Real disk_ = 0;
    Real a_ = 0;
    Real b_ = 0;
    std::vector<PrecisePoint> vertices_;
    std::vector<Segment> segments_;
    std::vector<Vector2> rough_;
    double slack_ = 0;
};

} // namespace chesil::test
