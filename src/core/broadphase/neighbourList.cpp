#include "core/broadphase/neighbourList.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

const std::vector<NeighbourSearch::Pair>& NeighbourSearch::find(
    const std::vector<Vector2>& positions, const std::vector<double>& radii, double margin)
{
    pairs_.clear();
    entries_.clear();
    if (positions.empty())
    {
        return pairs_;
    }

    const double cellSize = 2 * *std::max_element(radii.begin(), radii.end()) + margin;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
        // Beyond 10^18 cells, or not a number: all in one. Any cell is right, since distances decide.
        const auto cell = [cellSize](double x)
        { return static_cast<std::int64_t>(std::fmax(-1e18, std::fmin(std::floor(x / cellSize), 1e18))); };
        entries_.push_back({cell(positions[i].x()), cell(positions[i].y()), static_cast<std::int32_t>(i)});
    }
    std::sort(entries_.begin(), entries_.end());

    const auto near = [&](std::int32_t i, std::int32_t j)
    {
        const auto a = static_cast<std::size_t>(i);
        const auto b = static_cast<std::size_t>(j);
        const double reach = radii[a] + radii[b] + margin;
        return (positions[a] - positions[b]).squaredNorm() <= reach * reach;
    };
    // Each cell looks at the rest of its column's next cell and at three cells of the next column: every pair once.
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry)
    {
        for (auto other = entry + 1;
             other != entries_.end() && other->column == entry->column && other->row <= entry->row + 1;
             ++other)
        {
            if (near(entry->grain, other->grain))
            {
                pairs_.push_back(std::minmax(entry->grain, other->grain));
            }
        }
        const Entry first{entry->column + 1, entry->row - 1, -1};
        for (auto other = std::lower_bound(entry, entries_.end(), first);
             other != entries_.end() && other->column == first.column && other->row <= entry->row + 1;
             ++other)
        {
            if (near(entry->grain, other->grain))
            {
                pairs_.push_back(std::minmax(entry->grain, other->grain));
            }
        }
    }
    std::sort(pairs_.begin(), pairs_.end());
    return pairs_;
}

} // namespace chesil
