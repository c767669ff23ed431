#pragma once

#include "core/base/supportContract.hpp"
#include "core/base/twoLanes.hpp"
#include "core/base/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace chesil
{

/// A planar cubic Bezier segment B(t), 0 <= t <= 1, with control points in the grain's frame [m].
/// Source: Lai & Huang, polybezier model, eqs. (1)-(9). It fills one cache line.
class alignas(64) CubicBezier
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

/// Where a segment is furthest along a direction, and how fast its rise falls there: v of doc/contactKernel.md.
template <class Number>
struct SupportRoot
{
    Number parameter;
    Number bend;
};

/// See doc/supportFunction.md: from the rises of the three control edges along the direction, the first of them not negative,
/// the last one not positive. A quadratic's slope at its root is the root of its discriminant.
template <class Number>
SupportRoot<Number> supportRootWithin(const Number& rise0, const Number& rise1, const Number& rise2)
{
    const Number bend = squareRoot(rise1 * rise1 - rise0 * rise2);
    // The share of t before the middle, of 1 - t behind it: without a branch, which random directions mispredict.
    const auto late = rise1 > 0;
    const Number near = late ? -rise2 : rise0;
    const Number share = near / (near + (bend + magnitude(rise1)));
    return {late ? 1 - share : share, bend};
}

/// See doc/supportFunction.md, for any rises.
inline double supportParameterOfRises(double rise0, double rise1, double rise2)
{
    if (rise0 <= 0 && rise2 >= 0)
    {
        // No root: beyond an end, or along a straight segment's normal.
        const double rise = rise0 + rise1 + rise2;
        return rise > 0 ? 1.0 : rise < 0 ? 0.0 : 0.5;
    }
    const double first = std::max(0.0, rise0);
    return rise1 != 0 || first > 0 ? supportRootWithin(first, rise1, std::min(0.0, rise2)).parameter : 0.0;
}

inline SupportRoot<double> supportRootAnywhere(double rise0, double rise1, double rise2)
{
    const double t = supportParameterOfRises(rise0, rise1, rise2);
    return {t, (1 - t) * (rise0 - rise1) + t * (rise1 - rise2)};
}

inline SupportRoot<TwoLanes> supportRootAnywhere(const TwoLanes& rise0, const TwoLanes& rise1, const TwoLanes& rise2)
{
    const SupportRoot<double> first = supportRootAnywhere(rise0[0], rise1[0], rise2[0]);
    const SupportRoot<double> second = supportRootAnywhere(rise0[1], rise1[1], rise2[1]);
    return {TwoLanes{first.parameter, second.parameter}, TwoLanes{first.bend, second.bend}};
}

/// A CurvedPoint in coordinates, of one segment (double) or of two (TwoLanes).
template <class Number>
struct CurvedCoordinates
{
    Number x;
    Number y;
    Number radius;
    Number radiusFirst;
    Number radiusSecond;
    Number room;
};

/// A segment's control points in coordinates, and how its control edges run along a unit normal and along that turned by
/// 90 degrees. In coordinates, since these are the hottest lines of all: Eigen's temporaries cost a third.
template <class Number>
struct SegmentAlongNormal
{
    std::array<Number, 4> x;
    std::array<Number, 4> y;
    std::array<Number, 3> rise;
    std::array<Number, 3> along;

    SegmentAlongNormal(const std::array<Number, 4>& px, const std::array<Number, 4>& py, const Number& nx, const Number& ny) : x(px), y(py)
    {
        for (std::size_t i = 0; i < 3; ++i)
        {
            const Number dx = x[i + 1] - x[i];
            const Number dy = y[i + 1] - y[i];
            rise[i] = nx * dx + ny * dy;
            along[i] = nx * dy - ny * dx;
        }
    }

    /// Whether the normal is within the segment's range of normals, borders excluded.
    bool isWithin() const { return areAll((rise[0] > 0) & (rise[2] < 0)); }
};

template <class Number>
CurvedCoordinates<Number> curvedSupportAt(const SegmentAlongNormal<Number>& segment, const SupportRoot<Number>& root)
{
    const auto& [x, y, rise, along] = segment;
    const Number along0 = along[0], along1 = along[1], along2 = along[2];
    const Number rise0 = rise[0], rise1 = rise[1], rise2 = rise[2];
    const Number t = root.parameter;
    const Number s = 1 - t;
    const Number ss = s * s, st = 2 * (s * t), tt = t * t;
    const Number w0 = ss * s, w1 = 1.5 * st * s, w2 = 1.5 * st * t, w3 = tt * t;

    // doc/contactKernel.md, "Second-order data".
    const Number speed = ss * along0 + st * along1 + tt * along2;
    const Number bend = root.bend;
    const Number inverse = 1 / bend;
    const Number pace = speed * inverse;
    const Number gain0 = along1 - along0, gain1 = along2 - along1;
    const Number gain = s * gain0 + t * gain1;
    const Number twist = pace * ((rise1 - rise2) - (rise0 - rise1));
    const Number square = 0.375 * (pace * pace);
    const Number inner = 12 * gain - 2 * twist;
    const Number change = (4 * gain - twist) * inverse * (inner - twist);
    // The curve's end is the arc 3 u min(t, s) away, to first order.
    const Number end = t < s ? t : s;
    CurvedCoordinates<Number> result{
        (w0 * x[0] + w1 * x[1]) + (w2 * x[2] + w3 * x[3]),
        (w0 * y[0] + w1 * y[1]) + (w2 * y[2] + w3 * y[3]),
        1.5 * speed * pace,
        square * inner,
        square * (change + (8 * pace * (gain1 - gain0) + 12 * bend)),
        2 * end / pace};
    const auto curved = (bend > 0) & (speed > 0);
    if (!areAll(curved))
    {
        const Number none = 0 * s;
        const Number infinite = none + std::numeric_limits<double>::infinity();
        const auto moves = speed != 0;
        result.radius = curved ? result.radius : moves ? infinite : none;
        result.radiusFirst = moves ? result.radiusFirst : none;
        result.radiusSecond = moves ? result.radiusSecond : none;
        result.room = curved ? result.room : none;
    }
    return result;
}

template <class Number>
CurvedCoordinates<Number> curvedSupportOf(const SegmentAlongNormal<Number>& segment)
{
    const auto& rise = segment.rise;
    return curvedSupportAt(
        segment, segment.isWithin() ? supportRootWithin(rise[0], rise[1], rise[2]) : supportRootAnywhere(rise[0], rise[1], rise[2]));
}

inline CurvedPoint<2> CubicBezier::curvedSupport(const Vector2& normal) const
{
    const CurvedCoordinates<double> found = curvedSupportOf(SegmentAlongNormal<double>(
        {points_[0].x(), points_[1].x(), points_[2].x(), points_[3].x()},
        {points_[0].y(), points_[1].y(), points_[2].y(), points_[3].y()},
        normal.x(),
        normal.y()));
    return {Vector2(found.x, found.y), {found.radius, found.radiusFirst, found.radiusSecond}, found.room};
}

/// Two segments side by side along the unit normals (nx[0], ny[0]) and (nx[1], ny[1]).
inline SegmentAlongNormal<TwoLanes> sideBySide(const CubicBezier& a, const CubicBezier& b, const TwoLanes& nx, const TwoLanes& ny)
{
    const std::array<Vector2, 4>& p = a.controlPoints();
    const std::array<Vector2, 4>& q = b.controlPoints();
    const auto x = [&](std::size_t i) { return TwoLanes{p[i].x(), q[i].x()}; };
    const auto y = [&](std::size_t i) { return TwoLanes{p[i].y(), q[i].y()}; };
    return {{x(0), x(1), x(2), x(3)}, {y(0), y(1), y(2), y(3)}, nx, ny};
}

} // namespace chesil
