#include "core/shapes/circle.hpp"

#include "core/base/sizeRange.hpp"

#include <cmath>

namespace chesil
{

Circle::Circle(double radius) : radius_(radius)
{
    requireSize(radius, "a radius");
}

MassProperties Circle::massProperties() const
{
    const double area = M_PI * radius_ * radius_;
    return {area, area * radius_ * radius_ / 2};
}

Outline Circle::outline() const
{
    return {EllipticArc{Vector2::Zero(), Vector2(radius_, 0), Vector2(0, radius_), 0, 2 * M_PI}};
}

} // namespace chesil
