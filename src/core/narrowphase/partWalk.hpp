#pragma once

#include "core/base/pose.hpp"
#include "core/base/supportContract.hpp"

#include <cstddef>

namespace chesil
{

/// Walks round a placed outline from part to part, `sense` 1 for counter-clockwise, -1 for clockwise. World axes. A
/// shape without parts is one that never ends.
template <class ShapeType>
class PartWalk
{
public:
    /// `side` is -1 for the second shape of A - B, whose normals are turned round.
    PartWalk(const ShapeType& shape, const Rotation<2>& rotation, double side, const Vector2& normal, int sense)
    : shape_(shape), rotation_(rotation), side_(side), sense_(sense)
    {
        if constexpr (OffersParts<ShapeType>::value)
        {
            part_ = shape.partAt(rotation.applyInverse(side * normal));
        }
    }

    /// Lower bound of the radius of curvature of this part [m].
    double leastRadius() const
    {
        if constexpr (OffersParts<ShapeType>::value)
        {
            return shape_.partRadius(part_);
        }
        return shape_.leastRadius();
    }

    /// Brings `next`, less than half a turn ahead, back to where this part ends, if that comes before; whether it did.
    bool endsBefore(Vector2& next) const
    {
        if constexpr (OffersParts<ShapeType>::value)
        {
            const Vector2 own =
                side_ * rotation_.apply(shape_.partStart(sense_ > 0 ? shape_.partAfter(part_) : part_));
            if (sense_ * cross(own, next) > 0)
            {
                next = own;
                return true;
            }
        }
        return false;
    }

    void advance()
    {
        if constexpr (OffersParts<ShapeType>::value)
        {
            part_ = sense_ > 0 ? shape_.partAfter(part_) : shape_.partBefore(part_);
        }
    }

private:
    const ShapeType& shape_;
    const Rotation<2>& rotation_;
    double side_;
    int sense_;
    std::size_t part_ = 0;
};

} // namespace chesil
