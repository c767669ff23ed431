#pragma once

#include "core/base/supportContract.hpp"
#include "core/base/vector.hpp"
#include "core/geometry/outline.hpp"
#include "core/shapes/massProperties.hpp"

#include <limits>

namespace chesil
{

/// A disk, centred at the origin of its frame. Throws ValueError unless the radius [m] is finite and
/// positive.
class Circle
{
public:
    static constexpr const char* typeName = "circle";

    explicit Circle(double radius);

    double radius() const { return radius_; }

    Vector2 support(const Vector2& direction) const
    {
        const double length = direction.norm();
        return length > 0 ? Vector2(direction * (radius_ / length)) : Vector2(radius_, 0);
    }

    double boundingRadius() const { return radius_; }

    CurvedPoint<2> curvedSupport(const Vector2& normal) const { return {radius_ * normal, {radius_, 0, 0}, std::numeric_limits<double>::infinity()}; }
    double leastRadiusBetween(const Vector2&, const Vector2&) const { return radius_; }
    double leastRadius() const { return radius_; }
    double innerRadius() const { return radius_; }
    static constexpr bool mayHaveStraightSides = false;

    MassProperties massProperties() const;
    Outline outline() const;

private:
    double radius_;
};

} // namespace chesil
