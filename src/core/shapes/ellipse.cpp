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

// From part 0, about the y axis, counter-clockwise.
std::size_t Ellipse::partAt(const Vector2& normal) const
{
    const bool aboutY = b_ * std::abs(normal.y()) >= a_ * std::abs(normal.x());
    return aboutY ? (normal.y() >= 0 ? 0 : 2) : (normal.x() < 0 ? 1 : 3);
}

Vector2 Ellipse::partStart(std::size_t part) const
{
    const Vector2 first = Vector2(b_, a_) / std::hypot(a_, b_);
    const Vector2 start = part % 2 == 0 ? first : Vector2(-first.x(), first.y());
    return part < 2 ? start : Vector2(-start);
}

double Ellipse::partRadius(std::size_t part) const
{
    const bool isFlat = (part % 2 == 0) == (a_ > b_);
    const double diagonal = std::hypot(a_, b_);
    return isFlat ? diagonal / a_ * (diagonal / b_) * diagonal / std::sqrt(8.0) : leastRadius();
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
