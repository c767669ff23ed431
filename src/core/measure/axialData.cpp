#include "core/measure/axialData.hpp"

#include "core/base/setupError.hpp"

namespace chesil
{

std::size_t roseBin(double angle, std::size_t bins)
{
    const double count = static_cast<double>(bins);
    const double fromFirstEdge = axisAngle(angle + 0.5 * M_PI / count);
    // Below the number of bins also after rounding: the largest double below pi gives the quotient 1 - 2^-53.
    return static_cast<std::size_t>(fromFirstEdge / M_PI * count);
}

std::vector<std::size_t> roseHistogram(const std::vector<double>& angles, std::size_t bins)
{
    if (bins == 0)
    {
        throw ValueError("0 bins", "at least 1");
    }
    std::vector<std::size_t> counts(bins, 0);
    for (const double angle : angles)
    {
        if (!std::isfinite(angle))
        {
            throw ValueError("angle " + numberText(angle), "a finite one");
        }
        ++counts[roseBin(angle, bins)];
    }
    return counts;
}

} // namespace chesil
