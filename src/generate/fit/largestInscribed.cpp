#include "generate/image/convexHull.hpp"

#include <algorithm>

namespace chesil
{

namespace
{

/// The largest twice the area, seen from the first vertex, of chains of so many steps that end at vertex k.
struct Chains
{
    std::vector<double> areas;
    std::vector<std::size_t> before;
};

Chains longer(const Chains& chains, const std::vector<Vector2>& polygon)
{
    const std::size_t size = polygon.size();
    Chains next{std::vector<double>(size, -1), std::vector<std::size_t>(size, 0)};
    for (std::size_t end = 1; end < size; ++end)
    {
        for (std::size_t start = 0; start < end; ++start)
        {
            const double area =
                chains.areas[start] + cross(polygon[start] - polygon[0], polygon[end] - polygon[0]);
            if (chains.areas[start] >= 0 && area > next.areas[end])
            {
                next.areas[end] = area;
                next.before[end] = start;
            }
        }
    }
    return next;
}

/// Vertices of the largest polygon that has the first one among its, and twice its area.
std::pair<std::vector<Vector2>, double> largestFromFirst(const std::vector<Vector2>& polygon,
                                                         std::size_t count)
{
    std::vector<Chains> chains{{std::vector<double>(polygon.size(), -1), {}}};
    chains[0].areas[0] = 0;
    for (std::size_t step = 1; step < count; ++step)
    {
        chains.push_back(longer(chains.back(), polygon));
    }
    const std::vector<double>& areas = chains.back().areas;
    auto vertex = static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
    const double area = areas[vertex];
    std::vector<Vector2> vertices;
    for (std::size_t step = count; step-- > 0;)
    {
        vertices.push_back(polygon[vertex]);
        vertex = step > 0 ? chains[step].before[vertex] : 0;
    }
    std::reverse(vertices.begin(), vertices.end());
    return {vertices, area};
}

} // namespace

std::vector<Vector2> largestInscribed(const std::vector<Vector2>& polygon, int count)
{
    const auto wanted = static_cast<std::size_t>(count);
    if (wanted >= polygon.size())
    {
        return polygon;
    }
    std::vector<Vector2> best;
    double largest = 0;
    std::vector<Vector2> turned = polygon;
    for (std::size_t first = 0; first < polygon.size(); ++first)
    {
        auto [vertices, area] = largestFromFirst(turned, wanted);
        if (area > largest)
        {
            largest = area;
            best = std::move(vertices);
        }
        std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    }
    return best;
}

} // namespace chesil
