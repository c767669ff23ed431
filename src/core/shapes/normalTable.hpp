#pragma once

#include "core/base/tolerances.hpp"
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

    /// `normals[i]` is the outward normal at the start of piece i; counter-clockwise order, where rounding may turn
    /// one back by a little (tolerances::convexity at each of a piece's control points).
    explicit NormalTable(const std::vector<Vector2>& normals)
    {
        constexpr double turn = 4;
        constexpr double back = 4 * tolerances::convexity;
        for (const Vector2& normal : normals)
        {
            double key = diamondAngle(normal);
            if (!keys_.empty())
            {
                // From the last key on it rises, by less than a turn; what turns back stays where it is.
                const double last = keys_.back();
                key += turn * std::ceil((last - back - key) / turn);
                key = key < last || key >= last + turn - back ? last : key;
            }
            keys_.push_back(key);
        }
        // One turn holds all: those beyond its end are the first.
        const auto beyond = std::lower_bound(keys_.begin(), keys_.end(), turn);
        first_ = beyond == keys_.end() ? 0 : static_cast<std::size_t>(beyond - keys_.begin());
        std::for_each(beyond, keys_.end(), [](double& key) { key -= turn; });
        std::rotate(keys_.begin(), beyond, keys_.end());
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
