#pragma once

#include "core/base/supportContract.hpp"
#include "core/base/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace chesil
{

/// A planar cubic Bezier segment B(t), 0 <= t <= 1, with control points in the grain's frame [m].
/// Source: Lai & Huang, polybezier model, eqs. (1)-(9).
class CubicBezier
{
public:
    CubicBezier() = default;
    explicit CubicBezier(const std::array<Vector2, 4>& controlPoints) : points_(controlPoints) {}

    /// The straight segment from a to b, run through at constant speed.
    static CubicBezier straight(const Vector2& a, const Vector2& b);

    const std::array<Vector2, 4>& controlPoints() const { return points_; }
    const Vector2& start() const { return points_[0]; }
    const Vector2& end() const { return points_[3]; }

    Vector2 at(double t) const;

    /// dB/dt [m].
    Vector2 derivative(double t) const;

    /// d2B/dt2 [m].
    Vector2 secondDerivative(double t) const;

    /// The tangent's direction (not normalised) at the start or end: the first control edge that is
    /// not of zero length, so that repeated control points are no exception. Zero if all points agree.
    Vector2 startTangent() const;
    Vector2 endTangent() const;

    /// Parameter of the point furthest along `direction`, for a segment that turns counter-clockwise by
    /// less than 180 degrees. A direction outside the segment's range of normals gives the nearer end;
    /// a straight segment perpendicular to it gives the middle, 0.5. Free of cancellation and of
    /// division by zero: see doc/supportFunction.md, which derives it from eqs. (5)-(9).
    double supportParameter(const Vector2& direction) const;

    /// The support point along a unit normal within the segment's range of normals, with the radius of curvature
    /// there; doc/contactKernel.md derives it.
    CurvedPoint<2> curvedSupport(const Vector2& normal) const;

    /// Radius of curvature [m], positive if turning counter-clockwise; infinite where straight.
    double curvatureRadius(double t) const;

    /// Lower bound of the radius of curvature over a segment that turns counter-clockwise by less than 180 degrees;
    /// within a few per cent of the least one unless the speed vanishes, and 0 then.
    double leastCurvatureRadius() const;

    /// The part from t0 to t1 as a segment of its own.
    CubicBezier part(double t0, double t1) const;

    /// Both parts at t (de Casteljau).
    std::pair<CubicBezier, CubicBezier> split(double t) const;

    CubicBezier transformed(const Vector2& translation, double cosine, double sine, double scale) const;

private:
    std::array<Vector2, 4> points_{Vector2::Zero(), Vector2::Zero(), Vector2::Zero(), Vector2::Zero()};
};

inline Vector2 CubicBezier::at(double t) const
{
    const double s = 1 - t;
    return s * s * s * points_[0] + 3 * s * t * (s * points_[1] + t * points_[2]) + t * t * t * points_[3];
}

/// See doc/supportFunction.md; the rises of the three control edges along the direction.
inline double supportParameterOfRises(double rise0, double rise1, double rise2)
{
    if (rise0 <= 0 && rise2 >= 0)
    {
        // No root: beyond an end, or along a straight segment's normal.
        const double rise = rise0 + rise1 + rise2;
        return rise > 0 ? 1.0 : rise < 0 ? 0.0 : 0.5;
    }
    const double a0 = std::max(0.0, rise0);
    const double a2 = std::min(0.0, rise2);
    const double sum = std::sqrt(rise1 * rise1 - a0 * a2) + std::abs(rise1);
    // The share of t before the middle, of 1 - t behind it: without a branch, which random directions mispredict.
    const double late = rise1 > 0 ? 1 : 0;
    const double near = late * -a2 + (1 - late) * a0;
    const double whole = near + sum;
    return whole > 0 ? std::abs(late - near / whole) : 0.0;
}

inline CurvedPoint<2> CubicBezier::curvedSupport(const Vector2& normal) const
{
    // In coordinates, since this is the hottest line of all: Eigen's temporaries cost a third.
    const double nx = normal.x();
    const double ny = normal.y();
    const double x0 = points_[1].x() - points_[0].x(), y0 = points_[1].y() - points_[0].y();
    const double x1 = points_[2].x() - points_[1].x(), y1 = points_[2].y() - points_[1].y();
    const double x2 = points_[3].x() - points_[2].x(), y2 = points_[3].y() - points_[2].y();
    const double rise0 = nx * x0 + ny * y0;
    const double rise1 = nx * x1 + ny * y1;
    const double rise2 = nx * x2 + ny * y2;
    const double t = supportParameterOfRises(rise0, rise1, rise2);
    const double s = 1 - t;
    const double ss = s * s, st = 2 * s * t, tt = t * t;
    const double along0 = nx * y0 - ny * x0, along1 = nx * y1 - ny * x1, along2 = nx * y2 - ny * x2;
    const double speed = ss * along0 + st * along1 + tt * along2;
    const double bend0 = rise0 - rise1, bend1 = rise1 - rise2;
    const double bend = s * bend0 + t * bend1;
    CurvatureRadius radius;
    if (speed != 0)
    {
        // doc/contactKernel.md, "The radius of curvature and its derivatives".
        const double inverse = 1 / bend;
        const double pace = speed * inverse;
        const double gain = s * (along1 - along0) + t * (along2 - along1);
        const double twist = bend1 - bend0;
        const double jerk = along0 - 2 * along1 + along2;
        radius.value = bend > 0 ? 1.5 * speed * pace : std::numeric_limits<double>::infinity();
        const double square = 0.375 * pace * pace;
        const double inner = 12 * gain - 2 * pace * twist;
        radius.first = square * inner;
        const double paceChange = (4 * gain - pace * twist) * inverse;
        radius.second = square * (paceChange * (inner - pace * twist) + 8 * pace * jerk + 12 * bend);
    }
    const double w0 = ss * s, w1 = 1.5 * st * s, w2 = 1.5 * st * t, w3 = tt * t;
    const double x = (w0 * points_[0].x() + w1 * points_[1].x()) + (w2 * points_[2].x() + w3 * points_[3].x());
    const double y = (w0 * points_[0].y() + w1 * points_[1].y()) + (w2 * points_[2].y() + w3 * points_[3].y());
    // The curve's end is the arc 3 u min(t, s) away, to first order.
    const double room = radius.value > 0 ? 3 * std::abs(speed) * std::min(t, s) / radius.value : 0;
    return {Vector2(x, y), radius, room};
}

} // namespace chesil
