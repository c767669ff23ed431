#include "core/measure/alignment.hpp"

namespace chesil
{

std::optional<SecondHarmonic> alignment(const std::vector<double>& axisAngles)
{
    if (axisAngles.empty())
    {
        return std::nullopt;
    }
    SecondHarmonic mean;
    for (const double angle : axisAngles)
    {
        mean.cosine += std::cos(2 * angle);
        mean.sine += std::sin(2 * angle);
    }
    const double count = static_cast<double>(axisAngles.size());
    mean.cosine /= count;
    mean.sine /= count;
    return mean;
}

} // namespace chesil
