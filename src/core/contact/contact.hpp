#pragma once

#include "core/base/vector.hpp"

#include <cstdint>
#include <tuple>

namespace chesil
{

/// A pair of near bodies and what is carried from step to step. World frame.
template <int Dim>
struct Contact
{
    std::int32_t first;
    /// Grain, or wall w as -1 - w.
    std::int32_t second;
    /// Two straight sides touch at both ends of the length they share: 1 for the second end, whose entry
    /// follows that of the first.
    std::int32_t place = 0;
    /// Overlap [m]; 0 without contact.
    double depth = 0;
    /// Unit, from first to second, of the last contact; without contact the direction that separated them.
    Vector<Dim> normal = Vector<Dim>::Zero();
    /// By how much the normal turned in the last step [rad].
    double turn = 0;
    /// Middle of the overlap [m].
    Vector<Dim> point = Vector<Dim>::Zero();
    /// On the first body [N].
    Vector<Dim> force = Vector<Dim>::Zero();

    static constexpr std::int32_t wallAsSecond(std::size_t wall) { return -1 - static_cast<std::int32_t>(wall); }

    bool withWall() const { return second < 0; }
    std::size_t wall() const { return static_cast<std::size_t>(-1 - second); }

    std::tuple<std::int32_t, std::int32_t, std::int32_t> key() const { return {first, second, place}; }
};

} // namespace chesil
