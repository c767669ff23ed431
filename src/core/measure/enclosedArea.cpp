#include "core/measure/enclosedArea.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

std::optional<double> enclosedArea(const std::vector<std::pair<Vector2, Vector2>>& halfPlanes)
{
    if (halfPlanes.empty())
    {
        return std::nullopt;
    }
    // What is left of each border line by the others, counter-clockwise with the domain on its left, is a side of the
    // polygon: area = 1/2 sum of start x end, about a point of the first border.
    const Vector2 origin = halfPlanes.front().first;
    double twice = 0;
    for (std::size_t i = 0; i < halfPlanes.size(); ++i)
    {
        const auto& [point, normal] = halfPlanes[i];
        const Vector2 along = -perpendicular(normal);
        double from = -std::numeric_limits<double>::infinity();
        double to = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < halfPlanes.size(); ++j)
        {
            const auto& [otherPoint, otherNormal] = halfPlanes[j];
            const double distance = (point - otherPoint).dot(otherNormal);
            const double slope = along.dot(otherNormal);
            if (i == j)
            {
                continue;
            }
            if (slope == 0)
            {
                // Parallel; of two that agree the first is the border.
                const bool outside = distance < 0 || (distance == 0 && j < i && normal.dot(otherNormal) > 0);
                to = outside ? from : to;
                continue;
            }
            (slope > 0 ? from : to) = slope > 0 ? std::max(from, -distance / slope) : std::min(to, -distance / slope);
        }
        if (from < to)
        {
            if (!std::isfinite(from) || !std::isfinite(to))
            {
                return std::nullopt;
            }
            twice += cross(point - origin + from * along, point - origin + to * along);
        }
    }
    return twice > 0 ? std::optional<double>(twice / 2) : std::nullopt;
}

} // namespace chesil
