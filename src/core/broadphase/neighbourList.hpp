#pragma once

#include "core/base/vector.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace chesil
{

/// Pairs of grains (i < j) whose bounding circles come within `margin` of each other, sorted by i, then j, so
/// that forces are summed in one order on any run. Cells of the widest grain's size are sorted by key; no
/// array over space, so that one grain flung far away costs nothing.
class NeighbourSearch
{
public:
    using Pair = std::pair<std::int32_t, std::int32_t>;

    /// positions and radii [m], entry i for grain i.
    const std::vector<Pair>& find(const std::vector<Vector2>& positions, const std::vector<double>& radii, double margin);

private:
    struct Entry
    {
        std::int64_t column;
        std::int64_t row;
        std::int32_t grain;

        bool operator<(const Entry& other) const
        {
            return column != other.column ? column < other.column : row != other.row ? row < other.row : grain < other.grain;
        }
    };

    std::vector<Entry> entries_;
    std::vector<Pair> pairs_;
};

} // namespace chesil
