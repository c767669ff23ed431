#pragma once

#include "core/base/pose.hpp"
#include "core/shapes/shape.hpp"
#include "unit/preciseCurve.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

/// The signed distance of two placed grains in long double, from its definition: no search of the kernel in it.
namespace chesil::test
{

inline Real preciseDot(const PrecisePoint& a, const PrecisePoint& b) { return a.x * b.x + a.y * b.y; }

/// How far a shape reaches along n, a unit vector of its own frame [m].
inline Real preciseReach(const Circle& circle, const PrecisePoint& n)
{
    return circle.radius() * std::sqrt(preciseDot(n, n));
}

inline Real preciseReach(const Ellipse& ellipse, const PrecisePoint& n)
{
    return std::hypot(ellipse.a() * n.x, ellipse.b() * n.y);
}

inline Real preciseReach(const ConvexPolygon& polygon, const PrecisePoint& n)
{
    Real furthest = -INFINITY;
    for (const Vector2& vertex : polygon.vertices())
    {
        furthest = std::max(furthest, preciseDot(n, {vertex.x(), vertex.y()}));
    }
    return furthest;
}

/// Both ends and both roots of the derivative are tried; a root that has lost digits errs by their square.
inline Real preciseReach(const CubicBezier& segment, const PrecisePoint& n)
{
    std::array<Real, 4> h;
    for (std::size_t i = 0; i < 4; ++i)
    {
        h[i] = preciseDot(n, {segment.controlPoints()[i].x(), segment.controlPoints()[i].y()});
    }
    Real furthest = std::max(h[0], h[3]);
    const Real a0 = h[1] - h[0];
    const Real a1 = h[2] - h[1];
    const Real a2 = h[3] - h[2];
    const Real discriminant = a1 * a1 - a0 * a2;
    if (discriminant < 0)
    {
        return furthest;
    }
    for (const Real root : {std::sqrt(discriminant), -std::sqrt(discriminant)})
    {
        for (const Real t : {a0 / (a0 - a1 + root), (a1 + root) / (a1 + root - a2)})
        {
            if (t > 0 && t < 1)
            {
                const Real s = 1 - t;
                furthest = std::max(
                    furthest, s * s * s * h[0] + 3 * s * t * (s * h[1] + t * h[2]) + t * t * t * h[3]);
            }
        }
    }
    return furthest;
}

inline Real preciseReach(const PolyBezier& grain, const PrecisePoint& n)
{
    Real furthest = -INFINITY;
    for (const CubicBezier& segment : grain.segments())
    {
        furthest = std::max(furthest, preciseReach(segment, n));
    }
    return furthest;
}

inline Real preciseReach(const Shape& shape, const PrecisePoint& n)
{
    return std::visit([&](const auto& actual) { return preciseReach(actual, n); }, shape);
}

/// Along n of the world's frame, from the grain's centroid; with the pose's own rounded cosine and sine.
inline Real preciseReach(const Shape& shape, const Pose<2>& pose, const PrecisePoint& n)
{
    const Vector2 x = pose.rotation.apply(Vector2::UnitX());
    return preciseReach(shape, {n.x * x.x() + n.y * x.y(), n.y * x.x() - n.x * x.y()});
}

/// Largest value of a function of the angle: a sweep, then golden section around each maximum that may be it.
/// `steepest` bounds its slope.
template <class Function>
Real largestOverAngles(const Function& at, Real steepest, int angles)
{
    const Real step = 2 * 3.14159265358979323846L / angles;
    std::vector<Real> values;
    for (int i = 0; i < angles; ++i)
    {
        values.push_back(at(i * step));
    }
    const Real best = *std::max_element(values.begin(), values.end());
    Real refined = best;
    const auto value = [&](int i) { return values[static_cast<std::size_t>((i + angles) % angles)]; };
    for (int i = 0; i < angles; ++i)
    {
        if (value(i) < value(i - 1) || value(i) < value(i + 1) || value(i) + steepest * step < best)
        {
            continue;
        }
        constexpr Real golden = 0.61803398874989484820L;
        Real low = (i - 1) * step;
        Real high = (i + 1) * step;
        Real t0 = high - golden * (high - low);
        Real t1 = low + golden * (high - low);
        Real h0 = at(t0);
        Real h1 = at(t1);
        for (int round = 0; round < 90; ++round)
        {
            const bool up = h0 < h1;
            (up ? low : high) = up ? t0 : t1;
            (up ? t0 : t1) = up ? t1 : t0;
            (up ? h0 : h1) = up ? h1 : h0;
            Real& fresh = up ? t1 : t0;
            fresh = up ? low + golden * (high - low) : high - golden * (high - low);
            (up ? h1 : h0) = at(fresh);
        }
        refined = std::max({refined, h0, h1});
    }
    return refined;
}

/// Largest over all n of n.(cB - cA) - hA(n) - hB(-n): the distance, or less the depth, of two grains [m].
inline Real preciseDistance(
    const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB, int angles = 2000)
{
    const PrecisePoint offset{
        Real(poseB.position.x()) - poseA.position.x(), Real(poseB.position.y()) - poseA.position.y()};
    const auto at = [&](Real angle)
    {
        const PrecisePoint n{std::cos(angle), std::sin(angle)};
        return preciseDot(n, offset) - preciseReach(a, poseA, n) - preciseReach(b, poseB, {-n.x, -n.y});
    };
    return largestOverAngles(at, boundingRadius(a) + boundingRadius(b) + std::hypot(offset.x, offset.y), angles);
}

/// Signed distance of a point from a grain's outline; negative inside [m].
inline Real preciseDistance(const Shape& shape, const Pose<2>& pose, const Vector2& point, int angles = 2000)
{
    const PrecisePoint offset{Real(point.x()) - pose.position.x(), Real(point.y()) - pose.position.y()};
    const auto at = [&](Real angle)
    {
        const PrecisePoint n{std::cos(angle), std::sin(angle)};
        return preciseDot(n, offset) - preciseReach(shape, pose, n);
    };
    return largestOverAngles(at, boundingRadius(shape) + std::hypot(offset.x, offset.y), angles);
}

} // namespace chesil::test
