#include "core/shapes/ellipse.hpp"

#include "core/base/setupError.hpp"

#include <cmath>

namespace chesil
{

Ellipse::Ellipse(double a, double b) : a_(a), b_(b)
{
    for (const double axis : {a, b})
    {
        if (!(std::isfinite(axis) && axis > 0))
        {
            throw ValueError(numberText(axis), "a half-axis > 0 [m]");
        }
    }
}

MassProperties Ellipse::massProperties() const
{
    const double area = M_PI * a_ * b_;
    return {area, area * (a_ * a_ + b_ * b_) / 4};
}

Outline Ellipse::outline() const
{
    return {EllipticArc{Vector2::Zero(), Vector2(a_, 0), Vector2(0, b_), 0, 2 * M_PI}};
}

} // namespace chesil
