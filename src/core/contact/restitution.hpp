#pragma once

#include <algorithm>
#include <cmath>

namespace chesil
{

/// The coefficient of restitution of a linear contact with the damping ratio z >= 0 whose force never attracts.
/// The damped oscillator lets go when its force changes sign, at the time 2 arccos(z)/(w sqrt(1 - z^2)), before
/// the overlap is back at zero: e = exp(-2 z arccos(z)/sqrt(1 - z^2)); beyond z = 1 with arcosh and z^2 - 1.
inline double restitutionOf(double dampingRatio)
{
    const double square = dampingRatio * dampingRatio;
    if (std::abs(1 - square) < 1e-10)
    {
        return std::exp(-2.0);
    }
    const double angle = square < 1 ? std::acos(dampingRatio) : std::acosh(dampingRatio);
    return std::exp(-2 * dampingRatio * angle / std::sqrt(std::abs(1 - square)));
}

/// The damping ratio that gives the coefficient of restitution e, 0 < e <= 1; the inverse of restitutionOf.
inline double dampingRatioOf(double restitution)
{
    // e falls from 1, and below 1/(2 z)^2: bisection for one of set-up's few calls.
    double low = 0;
    double high = std::max(1.0, 0.5 / std::sqrt(restitution));
    for (double middle = high / 2; low < middle && middle < high; middle = (low + high) / 2)
    {
        (restitutionOf(middle) > restitution ? low : high) = middle;
    }
    return low;
}

} // namespace chesil
