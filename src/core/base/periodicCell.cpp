#include "core/base/periodicCell.hpp"

#include "core/base/setupError.hpp"

#include <limits>
#include <utility>

namespace chesil
{

namespace
{

std::string textOf(const Vector2& vector)
{
    return "(" + numberText(vector.x()) + " " + numberText(vector.y()) + ")";
}

} // namespace

PeriodicCell::PeriodicCell(const Vector2& lower, const Vector2& first, const Vector2& second)
    : lower_(lower), vectors_{first, second}
{
    const std::string found = "a periodic cell at " + textOf(lower) + " with lattice vectors " +
                              textOf(first) + " and " + textOf(second);
    if (!lower.allFinite() || !first.allFinite() || !second.allFinite())
    {
        throw ValueError(found, "finite numbers [m]");
    }
    if (first.isZero(0) && second.isZero(0))
    {
        throw ValueError(found, "at least one lattice vector other than zero [m]");
    }
    reciprocal_ = reciprocalOf(first, second);
    if (!reciprocal_[0].allFinite() || !reciprocal_[1].allFinite())
    {
        throw ValueError(found, "lattice vectors that are not parallel [m]");
    }
    reduce();
}

std::array<Vector2, 2> PeriodicCell::reciprocalOf(const Vector2& first, const Vector2& second)
{
    if (first.isZero(0) || second.isZero(0))
    {
        const auto along = [](const Vector2& vector)
        { return vector.isZero(0) ? vector : Vector2(vector / vector.squaredNorm()); };
        return {along(first), along(second)};
    }
    const double area = cross(first, second);
    return {Vector2(-perpendicular(second) / area), Vector2(perpendicular(first) / area)};
}

/// Lagrange's reduction of a lattice in the plane: the longer vector less the multiple of the shorter one
/// that makes it shortest, until nothing is gained.
void PeriodicCell::reduce()
{
    LatticeVector shorter{first(), 1, 0};
    LatticeVector longer{second(), 0, 1};
    while (!first().isZero(0) && !second().isZero(0))
    {
        if (longer.vector.squaredNorm() < shorter.vector.squaredNorm())
        {
            std::swap(shorter, longer);
        }
        const double multiple = std::round(shorter.vector.dot(longer.vector) / shorter.vector.squaredNorm());
        const Vector2 rest = longer.vector - multiple * shorter.vector;
        if (!(rest.squaredNorm() < longer.vector.squaredNorm()) || !(std::abs(multiple) < 0x1p30))
        {
            break;
        }
        const auto times = static_cast<std::int64_t>(multiple);
        longer = {rest, longer.first - times * shorter.first, longer.second - times * shorter.second};
    }
    shortest_ = {shorter, longer};
    shortestReciprocal_ = reciprocalOf(shorter.vector, longer.vector);
}

Shift PeriodicCell::nearestShift(const Vector2& separation) const
{
    const Vector2 fraction(shortestReciprocal_[0].dot(separation), shortestReciprocal_[1].dot(separation));
    if (!isCountable(fraction) || !isCountable(fractionOf(lower_ + separation)))
    {
        return {};
    }
    // The shortest two vectors stand at 60 to 120 degrees: the nearest node is a corner of the mesh around
    // the point.
    Shift nearest;
    double least = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 4; ++corner)
    {
        const double m = -std::floor(fraction.x()) - corner % 2;
        const double n = -std::floor(fraction.y()) - corner / 2;
        const double distance =
            (separation + m * shortest_[0].vector + n * shortest_[1].vector).squaredNorm();
        if (distance < least)
        {
            least = distance;
            const auto sum = [m, n](std::int64_t a, std::int64_t b) {
                return static_cast<std::int32_t>(static_cast<std::int64_t>(m) * a +
                                                 static_cast<std::int64_t>(n) * b);
            };
            nearest = {sum(shortest_[0].first, shortest_[1].first),
                       sum(shortest_[0].second, shortest_[1].second)};
        }
    }
    return nearest;
}

} // namespace chesil
