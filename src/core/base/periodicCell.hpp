#pragma once

#include "core/base/vector.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace chesil
{

/// How many times each lattice vector of a periodic cell is added to get an image of a point.
struct Shift
{
    std::int32_t first = 0;
    std::int32_t second = 0;

    bool operator==(const Shift& other) const { return first == other.first && second == other.second; }
};

/// A Shift between grains of one neighbourhood, -8 to 7 either way: kept with every pair, in one byte.
struct NearShift
{
    std::int8_t first : 4;
    std::int8_t second : 4;

    constexpr NearShift() : first(0), second(0) {}
    constexpr NearShift(int towardsFirst, int towardsSecond)
    : first(static_cast<std::int8_t>(towardsFirst)), second(static_cast<std::int8_t>(towardsSecond))
    {
    }

    operator Shift() const { return {first, second}; }
    bool operator==(const NearShift& other) const { return first == other.first && second == other.second; }
};

/// A parallelogram, given by its lower corner and two lattice vectors, that repeats itself over the plane.
/// Simple shear tilts the second vector; a vector of zeros means no periodicity that way, and the cell is a
/// strip then, bounded by lines perpendicular to the other one. All in the world's frame.
class PeriodicCell
{
public:
    /// All in [m]. ValueError for numbers that are not finite, for two vectors of zeros and for parallel
    /// ones.
    PeriodicCell(const Vector2& lower, const Vector2& first, const Vector2& second);

    const Vector2& lower() const { return lower_; }
    const Vector2& first() const { return vectors_[0]; }
    const Vector2& second() const { return vectors_[1]; }

    /// Where a position [m] lies from the lower corner, in parts of the lattice vectors: in [0, 1) within the
    /// cell, 0 for a direction that does not repeat.
    Vector2 fractionOf(const Vector2& position) const
    {
        const Vector2 arm = position - lower_;
        return Vector2(reciprocal_[0].dot(arm), reciprocal_[1].dot(arm));
    }

    /// Distances [m] of opposite sides, perpendicular to them: those that `first` leads across, then those
    /// that `second` does. Infinite for a direction that does not repeat.
    Vector2 widths() const { return Vector2(1 / reciprocal_[0].norm(), 1 / reciprocal_[1].norm()); }

    /// What an image is away from the point itself [m].
    Vector2 offset(const Shift& shift) const
    {
        return shift.first * vectors_[0] + shift.second * vectors_[1];
    }

    /// The shift that makes `separation` + offset(shift) shortest [m], for any tilt. No shift for a
    /// separation that is not finite or is farther than 2^30 lattice vectors.
    Shift nearestShift(const Vector2& separation) const;

    /// Moves a position [m] into the cell, to rounding, and returns the shift that it has added. A position
    /// that is not finite or is farther than 2^30 lattice vectors stays where it is.
    Shift wrap(Vector2& position) const
    {
        const Vector2 fraction = fractionOf(position);
        if (!isCountable(fraction))
        {
            return {};
        }
        const Shift shift{-static_cast<std::int32_t>(std::floor(fraction.x())),
                          -static_cast<std::int32_t>(std::floor(fraction.y()))};
        position += offset(shift);
        return shift;
    }

private:
    /// A lattice vector that is a sum of whole multiples of the two given ones.
    struct LatticeVector
    {
        Vector2 vector;
        std::int64_t first;
        std::int64_t second;
    };

    static bool isCountable(const Vector2& fraction)
    {
        return std::abs(fraction.x()) <= 0x1p30 && std::abs(fraction.y()) <= 0x1p30;
    }

    static std::array<Vector2, 2> reciprocalOf(const Vector2& first, const Vector2& second);
    void reduce();

    Vector2 lower_;
    std::array<Vector2, 2> vectors_;
    std::array<Vector2, 2> reciprocal_;
    /// The same lattice by its two shortest vectors.
    std::array<LatticeVector, 2> shortest_;
    std::array<Vector2, 2> shortestReciprocal_;
};

} // namespace chesil
