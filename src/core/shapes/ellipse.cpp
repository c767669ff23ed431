#include "core/shapes/ellipse.hpp"

#include "core/base/sizeRange.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

Ellipse::Ellipse(double a, double b) : a_(a), b_(b)
{
    requireSize(a, "a half-axis");
    requireSize(b, "a half-axis");
}

OutlineStretch Ellipse::stretchAt(const Vector2& normal) const
{
    // The flatter half of the outline, on both sides of the short axis, ends where both terms under the root
    // are equal: radius ((a^2 + b^2)/2)^(3/2)/(a b).
    const double across = a_ > b_ ? a_ * std::abs(normal.x()) : b_ * std::abs(normal.y());
    const double along = a_ > b_ ? b_ * std::abs(normal.y()) : a_ * std::abs(normal.x());
    if (across > along)
    {
        return {leastRadius(), true, normal, normal};
    }
    const double diagonal = std::hypot(a_, b_);
    const double radius = diagonal / a_ * (diagonal / b_) * diagonal / std::sqrt(8.0);
    const Vector2 corner = Vector2(b_, a_) / diagonal;
    const Vector2 first = a_ > b_ ? corner : Vector2(corner.x(), -corner.y());
    const Vector2 last = Vector2(a_ > b_ ? -corner.x() : corner.x(), corner.y());
    const bool opposite = a_ > b_ ? normal.y() < 0 : normal.x() < 0;
    return {radius, false, opposite ? Vector2(-first) : first, opposite ? Vector2(-last) : last};
}

double Ellipse::leastRadiusBetween(const Vector2& first, const Vector2& last) const
{
    // The radius falls from the short axis to both tips of the long one: it is least at a tip, or at an end.
    const Vector2 tip = a_ > b_ ? Vector2::UnitX() : Vector2::UnitY();
    const auto holds = [&](const Vector2& normal) { return cross(first, normal) >= 0 && cross(normal, last) >= 0; };
    return holds(tip) || holds(-tip) ? leastRadius() : std::min(curvedSupport(first).radius.value, curvedSupport(last).radius.value);
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
