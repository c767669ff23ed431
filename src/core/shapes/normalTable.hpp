#pragma once

#include "core/base/vector.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace chesil
{

/// A measure of a direction's angle without trigonometry: rises from 0 to 4 over one turn (the "diamond
/// angle"), the same order as the angle itself.
inline double diamondAngle(const Vector2& direction)
{
    const double slope = direction.y() / (std::abs(direction.x()) + std::abs(direction.y()));
    if (direction.x() < 0)
    {
        return 2 - slope;
    }
    return slope < 0 ? 4 + slope : slope;
}

/// The pieces of a convex outline sorted by the outward normal at which each begins, so that the piece
/// that holds a direction's support point is found in O(log N).
class NormalTable
{
public:
    NormalTable() = default;

    /// `normals[i]` is the outward normal at the start of piece i; counter-clockwise order.
    explicit NormalTable(const std::vector<Vector2>& normals)
    {
        for (const Vector2& normal : normals)
        {
            keys_.push_back(diamondAngle(normal));
        }
        const auto smallest = std::min_element(keys_.begin(), keys_.end());
        first_ = static_cast<std::size_t>(smallest - keys_.begin());
        std::rotate(keys_.begin(), keys_.begin() + static_cast<std::ptrdiff_t>(first_), keys_.end());
        // Rounding may swap two equal normals; the search wants them sorted.
        std::sort(keys_.begin(), keys_.end());
    }

    /// The piece whose range of normals, up to the next piece's start, holds the direction.
    std::size_t find(const Vector2& direction) const
    {
        const auto next = std::upper_bound(keys_.begin(), keys_.end(), diamondAngle(direction));
        const std::size_t size = keys_.size();
        const std::size_t rank = next == keys_.begin() ? size - 1 : static_cast<std::size_t>(next - keys_.begin()) - 1;
        return rank + first_ < size ? rank + first_ : rank + first_ - size;
    }

private:
    std::vector<double> keys_;
    std::size_t first_ = 0;
};

} // namespace chesil
