#pragma once

#include "core/base/periodicCell.hpp"

#include <cstddef>
#include <cstdint>

namespace chesil
{

/// Which place of which two bodies a contact is, or may be.
struct PairKey
{
    std::int32_t first;
    /// Grain, or wall w as -1 - w.
    std::int32_t second;
    /// Two straight sides touch at both ends of the length they share: 1 for the second end, whose entry
    /// follows that of the first.
    std::int8_t place = 0;
    /// The image of `second` that `first` meets, in a periodic cell; no part of the order.
    NearShift shift{};

    static constexpr std::int32_t wallAsSecond(std::size_t wall) { return -1 - static_cast<std::int32_t>(wall); }

    bool withWall() const { return second < 0; }
    bool withImage() const { return !(shift == NearShift{}); }
    std::size_t wall() const { return static_cast<std::size_t>(-1 - second); }

    bool operator==(const PairKey& other) const
    {
        return first == other.first && second == other.second && place == other.place;
    }

    /// Grains before walls, then by first, second and place.
    bool operator<(const PairKey& other) const
    {
        if (withWall() != other.withWall())
        {
            return other.withWall();
        }
        if (first != other.first)
        {
            return first < other.first;
        }
        return second != other.second ? second < other.second : place < other.place;
    }
};

} // namespace chesil
