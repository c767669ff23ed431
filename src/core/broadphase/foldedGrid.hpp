#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace chesil
{

/// Rectangular cells over the whole plane, folded onto a ring of 2^k buckets: a step to the next column goes
/// one bucket on, a step to the next row `stride` buckets. Neighbours of a cell are thus the same steps away
/// from any bucket, the three cells of a row lie side by side, and no array grows with the space that grains
/// fill. The stride is near the golden section of the ring, so that rows of any length spread over it evenly,
/// and the nine cells around a bucket are nine buckets. Cells far from each other that share a bucket are
/// told apart by the distances.
class FoldedGrid
{
public:
    /// A cell must be wider than what is looked for by this factor: rounding then never skips a column, see
    /// `farthest`.
    static constexpr double slack = 1 + 0x1p-10;

    /// Cells of `width` and `height` [m], 0 for one column or row only; at least `buckets` of them.
    FoldedGrid(double width, double height, std::size_t buckets)
        : inverseWidth_(inverseOf(width)), inverseHeight_(inverseOf(height))
    {
        std::uint32_t number = 64;
        while (number < buckets)
        {
            number *= 2;
        }
        mask_ = number - 1;
        stride_ = static_cast<std::uint32_t>(0.6180339887498949 * number) | 1u;
    }

    /// Numbers of the column and the row of finite coordinates [m]. Beyond 10^12 cells, all is one: there
    /// rounding begins to eat up the slack.
    std::int64_t columnOf(double x) const { return floorOf(x * inverseWidth_); }
    std::int64_t rowOf(double y) const { return floorOf(y * inverseHeight_); }

    std::uint32_t bucketOf(std::int64_t column, std::int64_t row) const
    {
        return (static_cast<std::uint32_t>(column) + static_cast<std::uint32_t>(row) * stride_) & mask_;
    }

    /// The bucket one row up and one column back; with the two after it, the row ahead of a cell.
    std::uint32_t aheadOf(std::uint32_t bucket) const { return (bucket + stride_ - 1) & mask_; }

    std::uint32_t size() const { return mask_ + 1; }

private:
    static constexpr double farthest = 0x1p40;
    /// Its inverse is finite.
    static constexpr double leastSize = 1e-300;

    static double inverseOf(double size) { return size > leastSize ? 1 / size : 0; }

    static std::int64_t floorOf(double inCells)
    {
        const double near = std::min(std::max(inCells, -farthest), farthest);
        const auto towardsZero = static_cast<std::int64_t>(near);
        return towardsZero - (near < static_cast<double>(towardsZero));
    }

    double inverseWidth_;
    double inverseHeight_;
    std::uint32_t mask_;
    std::uint32_t stride_;
};

} // namespace chesil
