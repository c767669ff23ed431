#pragma once

#include "core/base/periodicCell.hpp"
#include "core/base/vector.hpp"

#include <cstdint>

namespace chesil
{

/// Which place of which two bodies a contact is.
struct ContactKey
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
    std::size_t wall() const { return static_cast<std::size_t>(-1 - second); }

    bool operator==(const ContactKey& other) const
    {
        return first == other.first && second == other.second && place == other.place;
    }

    /// Grains before walls, then by first, second and place.
    bool operator<(const ContactKey& other) const
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

/// A pair of near bodies and what is carried from step to step. World frame.
template <int Dim>
struct Contact : ContactKey
{
    /// By how much the normal turned in the last step [rad].
    float turn = 0;
    /// Overlap [m]; 0 without contact.
    double depth = 0;
    /// Unit, from first to second, of the last contact; without contact the direction that separated them.
    Vector<Dim> normal = Vector<Dim>::Zero();
    /// Middle of the overlap [m].
    Vector<Dim> point = Vector<Dim>::Zero();
    /// On the first body [N].
    Vector<Dim> force = Vector<Dim>::Zero();

    const ContactKey& key() const { return *this; }
};

} // namespace chesil
