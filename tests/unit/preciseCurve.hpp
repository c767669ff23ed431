#pragma once

#include "core/geometry/outline.hpp"

#include <array>
#include <cmath>
#include <variant>
#include <vector>

/// Curves, their moments and their heights in long double: references with at least three digits more than
/// what is tested, by other formulas than those tested.
namespace chesil::test
{

using Real = long double;

struct PrecisePoint
{
    Real x = 0;
    Real y = 0;
};

/// The point and the derivative at t in [0, 1] of a piece of an outline.
inline PrecisePoint preciseAt(const CubicBezier& segment, Real t)
{
    const Real s = 1 - t;
    const std::array<Real, 4> share{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    PrecisePoint sum;
    for (std::size_t i = 0; i < 4; ++i)
    {
        sum.x += share[i] * segment.controlPoints()[i].x();
        sum.y += share[i] * segment.controlPoints()[i].y();
    }
    return sum;
}

inline PrecisePoint preciseAt(const EllipticArc& arc, Real t)
{
    const Real angle = arc.from + (static_cast<Real>(arc.to) - arc.from) * t;
    const Real c = std::cos(angle);
    const Real s = std::sin(angle);
    return {arc.centre.x() + c * arc.axisA.x() + s * arc.axisB.x(),
            arc.centre.y() + c * arc.axisA.y() + s * arc.axisB.y()};
}

inline PrecisePoint preciseDerivative(const CubicBezier& segment, Real t)
{
    const Real s = 1 - t;
    const std::array<Real, 3> share{3 * s * s, 6 * s * t, 3 * t * t};
    PrecisePoint sum;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const Vector2& from = segment.controlPoints()[i];
        const Vector2& to = segment.controlPoints()[i + 1];
        sum.x += share[i] * (static_cast<Real>(to.x()) - from.x());
        sum.y += share[i] * (static_cast<Real>(to.y()) - from.y());
    }
    return sum;
}

/// Area, first and polar moment about the origin of the region inside a closed chain of segments, from
/// area = int x dy, first = (int x^2 dy/2, - int y^2 dx/2), polar = int (x^3 dy - y^3 dx)/3.
struct PreciseMoments
{
    Real area = 0;
    PrecisePoint first;
    Real polar = 0;

    Real polarAboutCentroid() const { return polar - (first.x * first.x + first.y * first.y) / area; }
};

/// Abscissae and weights of Gauss's rule with 10 points on [0, 1], by Newton's method on Legendre's
/// polynomial.
inline std::vector<std::array<Real, 2>> gaussRule()
{
    constexpr int points = 10;
    std::vector<std::array<Real, 2>> rule;
    for (int i = 0; i < points; ++i)
    {
        Real x = std::cos(3.14159265358979323846L * (i + 0.75L) / (points + 0.5L));
        Real slope = 0;
        for (int iteration = 0; iteration < 8; ++iteration)
        {
            Real before = 1;
            Real value = x;
            for (int n = 2; n <= points; ++n)
            {
                const Real next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
                before = value;
                value = next;
            }
            slope = points * (x * value - before) / (x * x - 1);
            x -= value / slope;
        }
        rule.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
    }
    return rule;
}

inline PreciseMoments preciseMoments(const std::vector<CubicBezier>& boundary)
{
    static const std::vector<std::array<Real, 2>> rule = gaussRule();
    PreciseMoments sum;
    for (const CubicBezier& segment : boundary)
    {
        for (const auto& [t, weight] : rule)
        {
            const PrecisePoint p = preciseAt(segment, t);
            const PrecisePoint d = preciseDerivative(segment, t);
            sum.area += weight * p.x * d.y;
            sum.first.x += weight * p.x * p.x * d.y / 2;
            sum.first.y -= weight * p.y * p.y * d.x / 2;
            sum.polar += weight * (p.x * p.x * p.x * d.y - p.y * p.y * p.y * d.x) / 3;
        }
    }
    return sum;
}

/// How far a convex outline reaches along a direction: the best of a dense sweep of points, then refined by
/// golden section between its neighbours. Its error is quadratic in the last interval (1e-9 of a piece),
/// hence nothing but the rounding of long double.
class HeightSweep
{
public:
    explicit HeightSweep(Outline outline, int samplesOfAPiece)
        : outline_(std::move(outline)), samples_(samplesOfAPiece)
    {
        for (const OutlinePiece& piece : outline_)
        {
            for (int i = 0; i <= samples_; ++i)
            {
                points_.push_back(
                    std::visit([&](const auto& p) { return preciseAt(p, Real(i) / samples_); }, piece));
            }
        }
    }

    /// Largest product of an outline's point with the direction scaled to unit length [m].
    Real height(const Vector2& direction) const
    {
        const Real length = std::hypot(Real(direction.x()), Real(direction.y()));
        const PrecisePoint unit{direction.x() / length, direction.y() / length};
        std::size_t best = 0;
        Real highest = dot(unit, points_[0]);
        for (std::size_t i = 1; i < points_.size(); ++i)
        {
            const Real height = dot(unit, points_[i]);
            if (height > highest)
            {
                highest = height;
                best = i;
            }
        }
        const auto perPiece = static_cast<std::size_t>(samples_) + 1;
        const std::size_t piece = best / perPiece;
        const int sample = static_cast<int>(best % perPiece);
        highest = std::max(highest, refined(unit, piece, sample));
        // The end of a piece is the start of the next one, where the curve may rise on.
        const std::size_t pieces = outline_.size();
        if (sample == 0)
        {
            highest = std::max(highest, refined(unit, (piece + pieces - 1) % pieces, samples_));
        }
        if (sample == samples_)
        {
            highest = std::max(highest, refined(unit, (piece + 1) % pieces, 0));
        }
        return highest;
    }

private:
    static Real dot(const PrecisePoint& a, const PrecisePoint& b) { return a.x * b.x + a.y * b.y; }

    Real refined(const PrecisePoint& unit, std::size_t piece, int sample) const
    {
        const auto heightAt = [&](Real t)
        { return dot(unit, std::visit([&](const auto& p) { return preciseAt(p, t); }, outline_[piece])); };
        constexpr Real golden = 0.61803398874989484820L;
        Real low = std::max(Real(0), Real(sample - 1) / samples_);
        Real high = std::min(Real(1), Real(sample + 1) / samples_);
        Real t0 = high - golden * (high - low);
        Real t1 = low + golden * (high - low);
        Real h0 = heightAt(t0);
        Real h1 = heightAt(t1);
        for (int i = 0; i < 40; ++i)
        {
            if (h0 < h1)
            {
                low = t0;
                t0 = t1;
                h0 = h1;
                t1 = low + golden * (high - low);
                h1 = heightAt(t1);
            }
            else
            {
                high = t1;
                t1 = t0;
                h1 = h0;
                t0 = high - golden * (high - low);
                h0 = heightAt(t0);
            }
        }
        return std::max(h0, h1);
    }

    Outline outline_;
    int samples_;
    std::vector<PrecisePoint> points_;
};

} // namespace chesil::test
