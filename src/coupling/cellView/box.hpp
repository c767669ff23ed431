#pragma once

#include "core/base/vector.hpp"

#include <limits>

namespace chesil
{

/// An upright rectangle in the plane of the mesh [m]; empty until the first point is added.
struct Box
{
    Vector2 low = Vector2::Constant(std::numeric_limits<double>::infinity());
    Vector2 high = Vector2::Constant(-std::numeric_limits<double>::infinity());

    void add(const Vector2& point)
    {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }

    void add(const Box& other)
    {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }

    /// True if the two share a point, be it on their edges alone.
    bool overlaps(const Box& other) const
    {
        return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
    }
};

} // namespace chesil
