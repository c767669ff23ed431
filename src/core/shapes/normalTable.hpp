#pragma once

#include "core/base/tolerances.hpp"
#include "core/base/twoLanes.hpp"
#include "core/base/vector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace chesil
{

/// A measure of a direction's angle without trigonometry, branch or division, share/whole: rises from -2 to 2 over one
/// turn from -x on (the "diamond angle"), the same order as the angle itself.
struct DiamondAngle
{
    double share;
    double whole;

    explicit DiamondAngle(const Vector2& direction) : whole(std::abs(direction.x()) + std::abs(direction.y()))
    {
        share = std::copysign(whole - direction.x(), direction.y());
    }

    bool isFrom(double angle) const { return angle * whole <= share; }
};

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
            const DiamondAngle angle(normal);
            double key = angle.share / angle.whole;
            if (!keys_.empty())
            {
                // From the last key on it rises, by less than a turn; what turns back, or not at all, rises by the least
                // there is, so that the piece before keeps a direction of its own (a straight side has just one).
                const double last = keys_.back();
                key += turn * std::ceil((last - back - key) / turn);
                key = key <= last || key >= last + turn - back ? std::nextafter(last, 2 * turn) : key;
            }
            keys_.push_back(key);
        }
        // One turn holds all: those beyond its end are the first.
        const auto beyond = std::lower_bound(keys_.begin(), keys_.end(), turn / 2);
        const std::size_t size = keys_.size();
        const std::size_t first = beyond == keys_.end() ? 0 : static_cast<std::size_t>(beyond - keys_.begin());
        std::for_each(beyond, keys_.end(), [](double& key) { key -= turn; });
        std::rotate(keys_.begin(), beyond, keys_.end());
        size_ = size;
        pieceBeforeAll_ = (first + size - 1) % size;
        while (keys_.size() % keysAtATime != 0)
        {
            keys_.push_back(std::numeric_limits<double>::infinity());
        }
    }

    /// The piece whose range of normals, up to the next piece's start, holds the direction.
    std::size_t find(const Vector2& direction) const
    {
        const std::size_t piece = pieceBeforeAll_ + keysUpTo(DiamondAngle(direction));
        return piece < size_ ? piece : piece - size_;
    }

private:
    std::size_t keysUpTo(const DiamondAngle& angle) const
    {
        // Counting without a branch beats the search's mispredictions on the usual ten segments.
        constexpr std::size_t fewKeys = 32;
        if (keys_.size() > fewKeys)
        {
            return static_cast<std::size_t>(std::partition_point(
                                                keys_.begin(), keys_.end(), [&](double key) { return angle.isFrom(key); })
                                            - keys_.begin());
        }
        const double* keys = keys_.data();
        const TwoLanes share{angle.share, angle.share};
        const auto passed = [&](std::size_t i) -> TwoVerdicts { return TwoLanes{keys[i], keys[i + 1]} * angle.whole <= share; };
        // A true verdict is -1.
        TwoVerdicts count{0, 0};
        for (std::size_t i = 0; i < keys_.size(); i += keysAtATime)
        {
            count -= (passed(i) + passed(i + 2)) + passed(i + 4);
        }
        return static_cast<std::size_t>(count[0] + count[1]);
    }

    static constexpr std::size_t keysAtATime = 6;

    /// Sorted, filled up with infinity to whole groups of keysAtATime.
    std::vector<double> keys_;
    std::size_t size_ = 0;
    /// The piece of a direction that no key has passed; each key passed is one piece more.
    std::size_t pieceBeforeAll_ = 0;
};

} // namespace chesil
