#include "generate/descriptors/closedOutline.hpp"

#include <cmath>
#include <cstddef>

namespace chesil
{

double perimeterOf(const ClosedOutline& outline)
{
    double length = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        length += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    }
    return length;
}

ClosedOutline resampled(const ClosedOutline& outline, std::size_t count)
{
    const double step = perimeterOf(outline) / static_cast<double>(count);
    ClosedOutline points;
    points.reserve(count);
    double passed = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Vector2& start = outline[i];
        const Vector2 edge = outline[(i + 1) % outline.size()] - start;
        const double length = edge.norm();
        while (points.size() < count && static_cast<double>(points.size()) * step < passed + length)
        {
            points.push_back(start + (static_cast<double>(points.size()) * step - passed) / length * edge);
        }
        passed += length;
    }
    return points;
}

ClosedOutline smoothed(const ClosedOutline& outline, double deviation)
{
    constexpr double deviationsKept = 6;
    const auto size = static_cast<std::ptrdiff_t>(outline.size());
    const auto reach = static_cast<std::ptrdiff_t>(std::ceil(deviationsKept * deviation));
    std::vector<double> weights;
    double sum = 0;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k)
    {
        const double off = static_cast<double>(k) / deviation;
        weights.push_back((3 - off * off) / 2 * std::exp(-off * off / 2));
        sum += weights.back();
    }
    ClosedOutline points;
    points.reserve(outline.size());
    for (std::ptrdiff_t i = 0; i < size; ++i)
    {
        Vector2 mean = Vector2::Zero();
        for (std::ptrdiff_t k = -reach; k <= reach; ++k)
        {
            const std::ptrdiff_t neighbour = ((i + k) % size + size) % size;
            mean += weights[static_cast<std::size_t>(k + reach)] * outline[static_cast<std::size_t>(neighbour)];
        }
        points.push_back(mean / sum);
    }
    return points;
}

} // namespace chesil
