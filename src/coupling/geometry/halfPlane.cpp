#include "coupling/geometry/halfPlane.hpp"

#include "core/base/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chesil
{

namespace
{

/// The distance from a line along a cubic: its Bernstein coefficients are the control points' distances.
struct DistanceCubic
{
    std::array<double, 4> d;

    double at(double t) const
    {
        const double s = 1 - t;
        return s * s * (s * d[0] + 3 * t * d[1]) + t * t * (3 * s * d[2] + t * d[3]);
    }

    double slope(double t) const
    {
        const double s = 1 - t;
        return 3 * (s * s * (d[1] - d[0]) + 2 * s * t * (d[2] - d[1]) + t * t * (d[3] - d[2]));
    }
};

/// Where the slope vanishes, in rising order, inside (from, to): at most two places. With r = t/(1 - t) the
/// slope is c r^2 + 2 b r + a; its roots -q/c and -a/q, q = b +- sqrt(b^2 - a c) without cancellation, give
/// t = q/(q - c) and a/(a - q). A denominator of zero, a root at infinity, is skipped: flow solvers trap divisions by
/// zero.
int extrema(const DistanceCubic& distance, double from, double to, std::array<double, 2>& places)
{
    const double a = distance.d[1] - distance.d[0];
    const double b = distance.d[2] - distance.d[1];
    const double c = distance.d[3] - distance.d[2];
    const double discriminant = b * b - a * c;
    if (!(discriminant > 0))
    {
        return 0;
    }
    const double q = b + std::copysign(std::sqrt(discriminant), b);
    int count = 0;
    for (const auto& [numerator, denominator] : {std::pair{q, q - c}, std::pair{a, a - q}})
    {
        const double t = denominator != 0 ? numerator / denominator : from;
        if (t > from && t < to)
        {
            places[count++] = t;
        }
    }
    if (count == 2 && places[0] > places[1])
    {
        std::swap(places[0], places[1]);
    }
    return count;
}

/// The zero between `low` and `high`, where the distance is monotone and its sign differs: Newton from the
/// secant's zero, halving the bracket wherever Newton would leave it.
double crossing(const DistanceCubic& distance, double low, double high, double distanceLow,
                double distanceHigh)
{
    // A cubic's value carries a rounding of this order: a smaller one is zero.
    const auto& d = distance.d;
    const double rounding =
        2 * tolerances::epsilon * std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2]), std::abs(d[3])});
    // More than Newton with halvings ever needs on 52 bits.
    constexpr int mostSteps = 60;

    double t = low + (high - low) * (distanceLow / (distanceLow - distanceHigh));
    for (int step = 0; step < mostSteps; ++step)
    {
        const double value = distance.at(t);
        if (std::abs(value) <= rounding)
        {
            return t;
        }
        ((value < 0) == (distanceLow < 0) ? low : high) = t;
        const double slope = distance.slope(t);
        const bool newtonStaysNear = std::abs(value) < (high - low) * std::abs(slope);
        double next = newtonStaysNear ? t - value / slope : low;
        if (!(next > low && next < high))
        {
            next = 0.5 * (low + high);
        }
        if (std::abs(next - t) <= tolerances::epsilon)
        {
            return next;
        }
        t = next;
    }
    return t;
}

} // namespace

ParameterRanges partsInside(const CubicBezier& curve, double from, double to, double distanceFrom,
                            double distanceTo, const HalfPlane& plane)
{
    ParameterRanges inside;
    DistanceCubic distance;
    for (int i = 0; i < 4; ++i)
    {
        distance.d[i] = plane.distance(curve.controlPoints()[i]);
    }
    const auto [least, most] = std::minmax_element(distance.d.begin(), distance.d.end());
    if (*least >= 0 && distanceFrom >= 0 && distanceTo >= 0)
    {
        inside.add(from, to);
        return inside;
    }
    if (*most < 0 && distanceFrom < 0 && distanceTo < 0)
    {
        return inside;
    }

    std::array<double, 2> turns;
    const int turnCount = extrema(distance, from, to, turns);
    double enteredAt = from;
    double last = from;
    double distanceLast = distanceFrom;
    for (int i = 0; i <= turnCount; ++i)
    {
        const double next = i < turnCount ? turns[i] : to;
        const double distanceNext = i < turnCount ? distance.at(next) : distanceTo;
        if ((distanceLast >= 0) != (distanceNext >= 0))
        {
            const double t = crossing(distance, last, next, distanceLast, distanceNext);
            if (distanceLast >= 0)
            {
                inside.add(enteredAt, t);
            }
            enteredAt = t;
        }
        last = next;
        distanceLast = distanceNext;
    }
    if (distanceLast >= 0)
    {
        inside.add(enteredAt, to);
    }
    return inside;
}

ParameterRanges partsInside(const EllipticArc& arc, double from, double to, const HalfPlane& plane)
{
    // The distance is c + h cos(angle - middle).
    const double c = plane.distance(arc.centre);
    const double x = cross(plane.along, arc.axisA);
    const double y = cross(plane.along, arc.axisB);
    const double h = std::hypot(x, y);
    ParameterRanges inside;
    if (c >= h)
    {
        inside.add(from, to);
        return inside;
    }
    if (c <= -h)
    {
        return inside;
    }
    const double half = std::atan2(std::sqrt((h - c) * (h + c)), -c);
    const double turn = 2 * M_PI;
    const double start = std::atan2(y, x) - half;
    // The last start at or before `from`, and the one a turn later, are all that can reach [from, to].
    const double before = start - turn * std::ceil((start - from) / turn);
    for (const double begin : {before, before + turn})
    {
        inside.add(std::max(from, begin), std::min(to, begin + 2 * half));
    }
    return inside;
}

} // namespace chesil
