#pragma once

#include "core/base/supportContract.hpp"
#include "core/base/vector.hpp"
#include "core/geometry/outline.hpp"
#include "core/shapes/massProperties.hpp"

#include <limits>

namespace chesil
{

/// An ellipse with half-axes a along x and b along y of its frame [m]. Throws ValueError unless both are
/// finite and positive.
class Ellipse
{
public:
    static constexpr const char* typeName = "ellipse";

    Ellipse(double a, double b);

    double a() const { return a_; }
    double b() const { return b_; }

    /// The point (a^2 dx, b^2 dy)/sqrt(a^2 dx^2 + b^2 dy^2).
    Vector2 support(const Vector2& direction) const
    {
        const Vector2 stretched(a_ * direction.x(), b_ * direction.y());
        const double length = stretched.norm();
        return length > 0 ? Vector2(a_ * stretched.x() / length, b_ * stretched.y() / length) : Vector2(a_, 0);
    }

    double boundingRadius() const { return a_ > b_ ? a_ : b_; }

    /// The radius of curvature is r = (a b)^2/q^3 with q^2 = a^2 nx^2 + b^2 ny^2; with m = (b^2 - a^2) nx ny/q^2 its derivatives
    /// are r' = -3 r m and r'' = 3 r (5 m^2 - (b^2 - a^2)(nx^2 - ny^2)/q^2).
    CurvedPoint<2> curvedSupport(const Vector2& normal) const
    {
        const Vector2 stretched(a_ * normal.x(), b_ * normal.y());
        const double inverse = 1 / stretched.norm();
        const double share = a_ * b_ * inverse;
        const double radius = share * share * inverse;
        const double stretch = (b_ - a_) * inverse * ((a_ + b_) * inverse);
        const double change = stretch * normal.x() * normal.y();
        const double bend = stretch * (normal.x() - normal.y()) * (normal.x() + normal.y());
        return {
            Vector2(a_ * (stretched.x() * inverse), b_ * (stretched.y() * inverse)),
            {radius, -3 * radius * change, 3 * radius * (5 * change * change - bend)},
            std::numeric_limits<double>::infinity()};
    }

    /// Parts: the two flat halves and the two tips, which meet where both terms of q are equal.
    std::size_t partAt(const Vector2& normal) const;
    static std::size_t partAfter(std::size_t part) { return (part + 1) % 4; }
    static std::size_t partBefore(std::size_t part) { return (part + 3) % 4; }
    Vector2 partStart(std::size_t part) const;
    double partRadius(std::size_t part) const;
    double leastRadiusBetween(const Vector2& first, const Vector2& last) const;
    double leastRadius() const { return a_ < b_ ? a_ * (a_ / b_) : b_ * (b_ / a_); }
    double innerRadius() const { return a_ < b_ ? a_ : b_; }
    static constexpr bool mayHaveStraightSides = false;

    MassProperties massProperties() const;
    Outline outline() const;

private:
    double a_;
    double b_;
};

} // namespace chesil
