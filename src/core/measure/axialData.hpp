#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace chesil
{

/// Axes have no head: an angle and the same plus pi are one direction. Long axes of grains, contact normals
/// and principal directions are such data (Mardia & Jupp 2000, section 1.1). Angles [rad], world frame.

/// The axis' angle in [0, pi) of any finite angle.
inline double axisAngle(double angle)
{
    double inRange = std::fmod(angle, M_PI);
    if (inRange < 0)
    {
        inRange += M_PI;
    }
    // A tiny negative angle rounds to pi.
    return inRange < M_PI ? inRange : 0;
}

/// How many of the axes lie in each of `bins` equal bins of [0, pi). Bin k is centred on k pi/bins, so that
/// horizontal axes, and with an even number vertical ones, lie in the middle of a bin. Throws ValueError on
/// no bins and on an angle that is not finite.
std::vector<std::size_t> roseHistogram(const std::vector<double>& angles, std::size_t bins);

/// Number of the bin of one axis, as above, without its checks: `angle` finite, `bins` > 0.
std::size_t roseBin(double angle, std::size_t bins);

/// The function cosine cos 2t + sine sin 2t of the direction t, which is amplitude cos 2(t - direction).
struct SecondHarmonic
{
    double cosine = 0;
    double sine = 0;

    double amplitude() const { return std::hypot(cosine, sine); }

    /// In [0, pi); nothing if the amplitude is exactly 0. An amplitude of a few roundings has a direction
    /// without meaning.
    std::optional<double> direction() const
    {
        if (cosine == 0 && sine == 0)
        {
            return std::nullopt;
        }
        return axisAngle(0.5 * std::atan2(sine, cosine));
    }
};

} // namespace chesil
