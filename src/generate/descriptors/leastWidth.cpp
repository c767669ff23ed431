#include "generate/descriptors/leastWidth.hpp"

#include <algorithm>
#include <limits>

namespace chesil
{

LeastWidth leastWidth(const ClosedOutline& hull)
{
    const std::size_t size = hull.size();
    LeastWidth least{std::numeric_limits<double>::infinity(), 0, Vector2::UnitX()};
    std::size_t farthest = 1;
    for (std::size_t side = 0; side < size; ++side)
    {
        const Vector2 along = unit(hull[(side + 1) % size] - hull[side]);
        const auto height = [&](std::size_t vertex) { return cross(along, hull[vertex % size] - hull[side]); };
        while (height(farthest + 1) > height(farthest))
        {
            ++farthest;
        }
        const double width = height(farthest);
        if (width < least.width)
        {
            least.width = width;
            least.longAxis = along;
        }
    }
    const auto [low, high] = std::minmax_element(
        hull.begin(), hull.end(),
        [&](const Vector2& a, const Vector2& b) { return a.dot(least.longAxis) < b.dot(least.longAxis); });
    least.length = (*high - *low).dot(least.longAxis);
    return least;
}

} // namespace chesil
