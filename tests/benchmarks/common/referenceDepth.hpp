#pragma once

#include "benchmarks/common/overlappingPoses.hpp"
#include "core/shapes/convexPolygon.hpp"
#include "core/shapes/ellipse.hpp"
#include "core/shapes/polyBezier.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// Penetration depth without GJK, EPA or the shapes' own support functions, in long double. With
///
///     g(angle) = h_A(n) + h_B(-n) - (x_B - x_A).n,    n = (cos angle, sin angle),
///
/// h the height of a shape along a direction, it is the smallest g over one turn: how far B has to go along n
/// until the line with this normal separates the two.
namespace chesil::benchmark
{

using Real = long double;

struct RealVector
{
    Real x;
    Real y;

    RealVector operator-() const { return {-x, -y}; }
    Real dot(const Vector2& other) const { return x * other.x() + y * other.y(); }
};

// --- heights, direction in the shape's frame -----------------------------------------------------

inline Real height(const Ellipse& ellipse, const RealVector& direction)
{
    return std::hypot(ellipse.a() * direction.x, ellipse.b() * direction.y);
}

inline Real height(const ConvexPolygon& polygon, const RealVector& direction)
{
    Real highest = -std::numeric_limits<Real>::infinity();
    for (const Vector2& vertex : polygon.vertices())
    {
        highest = std::max(highest, direction.dot(vertex));
    }
    return highest;
}

/// Highest value of a cubic with these Bernstein coefficients, on [0, 1].
inline Real highestValue(Real f0, Real f1, Real f2, Real f3)
{
    const auto at = [=](Real t)
    {
        const Real s = 1 - t;
        return s * s * s * f0 + 3 * s * t * (s * f1 + t * f2) + t * t * t * f3;
    };
    Real highest = std::max(f0, f3);
    const auto consider = [&](Real t) { highest = t > 0 && t < 1 ? std::max(highest, at(t)) : highest; };

    // The derivative's third: a t^2 + 2 b t + c
    const Real a = (f1 - f0) - 2 * (f2 - f1) + (f3 - f2);
    const Real b = (f2 - f1) - (f1 - f0);
    const Real c = f1 - f0;
    const Real discriminant = b * b - a * c;
    if (discriminant >= 0)
    {
        const Real q = -(b + std::copysign(std::sqrt(discriminant), b));
        consider(q / a);
        consider(c / q);
    }
    return highest;
}

inline Real height(const PolyBezier& grain, const RealVector& direction)
{
    Real highest = -std::numeric_limits<Real>::infinity();
    for (const CubicBezier& segment : grain.segments())
    {
        const auto& points = segment.controlPoints();
        highest = std::max(highest, highestValue(direction.dot(points[0]), direction.dot(points[1]),
                                                 direction.dot(points[2]), direction.dot(points[3])));
    }
    return highest;
}

// --- the gap function and its minimum ------------------------------------------------------------

template <class ShapeType>
class Gap
{
public:
    Gap(const ShapeType& a, const ShapeType& b, const OverlappingPoses& poses)
        : a_(a), b_(b), axisA_(poses.a.rotation.apply(Vector2::UnitX())),
          axisB_(poses.b.rotation.apply(Vector2::UnitX())), offset_(poses.b.position - poses.a.position)
    {
    }

    Real operator()(Real angle) const
    {
        const RealVector normal{std::cos(angle), std::sin(angle)};
        return height(a_, local(normal, axisA_)) + height(b_, local(-normal, axisB_)) - normal.dot(offset_);
    }

private:
    static RealVector local(const RealVector& world, const Vector2& axis)
    {
        return {world.dot(axis), axis.x() * world.y - axis.y() * world.x};
    }

    const ShapeType& a_;
    const ShapeType& b_;
    Vector2 axisA_;
    Vector2 axisB_;
    Vector2 offset_;
};

/// By golden section; one minimum must lie in between.
template <class Function>
Real minimumBetween(const Function& function, Real low, Real high)
{
    const Real golden = (std::sqrt(Real(5)) - 1) / 2;
    Real left = high - golden * (high - low);
    Real right = low + golden * (high - low);
    Real atLeft = function(left);
    Real atRight = function(right);
    while (high - low > 1e-12L)
    {
        if (atLeft < atRight)
        {
            high = right;
            right = left;
            atRight = atLeft;
            left = high - golden * (high - low);
            atLeft = function(left);
        }
        else
        {
            low = left;
            left = right;
            atLeft = atRight;
            right = low + golden * (high - low);
            atRight = function(right);
        }
    }
    return std::min(atLeft, atRight);
}

/// Smooth shapes: a sweep over one turn, then each of its minima refined (g is flat there, so that 1e-12 rad
/// leave an error of 1e-24).
template <class ShapeType>
Real referenceDepth(const ShapeType& a, const ShapeType& b, const OverlappingPoses& poses)
{
    constexpr int samples = 1440;
    const Real step = 2 * std::acos(Real(-1)) / samples;
    const Gap<ShapeType> gap(a, b, poses);
    std::vector<Real> swept;
    for (int i = 0; i < samples; ++i)
    {
        swept.push_back(gap(i * step));
    }
    Real depth = std::numeric_limits<Real>::infinity();
    for (int i = 0; i < samples; ++i)
    {
        const auto value = [&](int k) { return swept[static_cast<std::size_t>((k + samples) % samples)]; };
        if (value(i) <= value(i - 1) && value(i) <= value(i + 1))
        {
            depth = std::min(depth, minimumBetween(gap, (i - 1) * step, (i + 1) * step));
        }
    }
    return depth;
}

/// Polygons: between the normals of the edges of A and -B, g is a sine's upper half and has no minimum if
/// the two overlap; so it is at one of these normals.
inline Real referenceDepth(const ConvexPolygon& a, const ConvexPolygon& b, const OverlappingPoses& poses)
{
    const Gap<ConvexPolygon> gap(a, b, poses);
    Real depth = std::numeric_limits<Real>::infinity();
    const auto consider = [&](const ConvexPolygon& polygon, const Pose<2>& pose, int sign)
    {
        const std::vector<Vector2>& vertices = polygon.vertices();
        const Vector2 axis = pose.rotation.apply(Vector2::UnitX());
        for (std::size_t i = 0; i < vertices.size(); ++i)
        {
            const Vector2& from = vertices[i];
            const Vector2& to = vertices[(i + 1) % vertices.size()];
            const Real x = sign * (Real(to.y()) - from.y());
            const Real y = -sign * (Real(to.x()) - from.x());
            depth =
                std::min(depth, gap(std::atan2(axis.y() * x + axis.x() * y, axis.x() * x - axis.y() * y)));
        }
    };
    consider(a, poses.a, 1);
    consider(b, poses.b, -1);
    return depth;
}

} // namespace chesil::benchmark
