#pragma once

#include "core/base/vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace chesil::benchmark
{

/// What else one could use, and the engine once did: cells of the widest grain's size, sorted by key;
/// bounding circles only. Pairs sorted by i, then j.
class SortedCells
{
public:
    using Pair = std::pair<std::int32_t, std::int32_t>;

    const std::vector<Pair>& find(const std::vector<Vector2>& positions, const std::vector<double>& radii,
                                  double margin)
    {
        pairs_.clear();
        entries_.clear();
        const double cellSize = 2 * *std::max_element(radii.begin(), radii.end()) + margin;
        for (std::size_t i = 0; i < positions.size(); ++i)
        {
            const auto cell = [cellSize](double x)
            { return static_cast<std::int64_t>(std::floor(x / cellSize)); };
            entries_.push_back(
                {cell(positions[i].x()), cell(positions[i].y()), static_cast<std::int32_t>(i)});
        }
        std::sort(entries_.begin(), entries_.end());
        const auto add = [&](std::int32_t i, std::int32_t j)
        {
            const auto a = static_cast<std::size_t>(i);
            const auto b = static_cast<std::size_t>(j);
            const double reach = radii[a] + radii[b] + margin;
            if ((positions[a] - positions[b]).squaredNorm() <= reach * reach)
            {
                pairs_.push_back(std::minmax(i, j));
            }
        };
        // The rest of the column's next cell, and three cells of the next column.
        for (auto entry = entries_.begin(); entry != entries_.end(); ++entry)
        {
            const auto isWithin = [&](auto other, std::int64_t column)
            { return other != entries_.end() && other->column == column && other->row <= entry->row + 1; };
            for (auto other = entry + 1; isWithin(other, entry->column); ++other)
            {
                add(entry->grain, other->grain);
            }
            const Entry first{entry->column + 1, entry->row - 1, -1};
            for (auto other = std::lower_bound(entry, entries_.end(), first); isWithin(other, first.column);
                 ++other)
            {
                add(entry->grain, other->grain);
            }
        }
        std::sort(pairs_.begin(), pairs_.end());
        return pairs_;
    }

private:
    struct Entry
    {
        std::int64_t column;
        std::int64_t row;
        std::int32_t grain;

        bool operator<(const Entry& other) const
        {
            return column != other.column ? column < other.column
                   : row != other.row     ? row < other.row
                                          : grain < other.grain;
        }
    };

    std::vector<Entry> entries_;
    std::vector<Pair> pairs_;
};

} // namespace chesil::benchmark
