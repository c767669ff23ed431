#pragma once

#include "core/base/vector.hpp"

#include <array>
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

    /// Radius of curvature [m], positive if turning counter-clockwise; infinite where straight.
    double curvatureRadius(double t) const;

    /// The part from t0 to t1 as a segment of its own.
    CubicBezier part(double t0, double t1) const;

    /// Both parts at t (de Casteljau).
    std::pair<CubicBezier, CubicBezier> split(double t) const;

    CubicBezier transformed(const Vector2& translation, double cosine, double sine, double scale) const;

private:
    std::array<Vector2, 4> points_{Vector2::Zero(), Vector2::Zero(), Vector2::Zero(), Vector2::Zero()};
};

} // namespace chesil
