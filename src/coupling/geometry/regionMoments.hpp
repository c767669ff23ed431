#pragma once

#include "core/base/vector.hpp"
#include "core/geometry/cubicBezier.hpp"
#include "core/geometry/ellipticArc.hpp"

namespace chesil
{

/// Area [m2] of a plane region and the integral of the position over it [m3], about a point stated beside
/// each use. Without the polar moment of AreaMoments, which no cell asks for.
struct RegionMoments
{
    double area = 0;
    Vector2 first = Vector2::Zero();

    /// The same, about a point that lies at `shift` from the old one.
    RegionMoments aboutPoint(const Vector2& shift) const { return {area, first - area * shift}; }

    RegionMoments& operator+=(const RegionMoments& other)
    {
        area += other.area;
        first += other.first;
        return *this;
    }
};

/// The sliver between a part of a curve, t in [from, to], and its chord, about the part's start; positive
/// on the left of a curve that turns counter-clockwise. Closed forms of Green's theorem that stay exact
/// to rounding however short the part: doc/solidFraction.md.
RegionMoments sliverMoments(const CubicBezier& curve, double from, double to);

/// The same for an arc, angles [rad]; `start` is the point at `from` [m].
RegionMoments sliverMoments(const EllipticArc& arc, double from, double to, const Vector2& start);

/// A triangle with corners 0, a, b, about 0.
inline RegionMoments triangleMoments(const Vector2& a, const Vector2& b)
{
    const double area = cross(a, b) / 2;
    return {area, area * (a + b) / 3};
}

} // namespace chesil
