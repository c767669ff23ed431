#pragma once

#include "core/base/vector.hpp"
#include "core/geometry/cubicBezier.hpp"
#include "core/geometry/ellipticArc.hpp"

#include <array>

namespace chesil
{

/// All points on the left of the line through `point` [m] along `along` [m], the line included.
struct HalfPlane
{
    Vector2 point;
    Vector2 along;

    /// Signed distance from the line times |along| [m2]; positive on the left.
    double distance(const Vector2& x) const { return cross(along, x - point); }
};

/// Up to two ranges of a curve's parameter, rising.
struct ParameterRanges
{
    struct Range
    {
        double from;
        double to;
    };

    std::array<Range, 2> ranges{};
    int count = 0;

    /// A range of no length is left out.
    void add(double from, double to)
    {
        if (from < to && count < 2)
        {
            ranges[count++] = {from, to};
        }
    }

    const Range* begin() const { return ranges.data(); }
    const Range* end() const { return ranges.data() + count; }
};

/// The parts of curve(t), from <= t <= to, that lie in the half-plane. `distanceFrom` and `distanceTo` are
/// the distances of the two ends as the caller knows them: neighbouring pieces that share a joint then agree
/// on which side it lies, whatever the rounding of curve(t). Derived in doc/solidFraction.md.
ParameterRanges partsInside(const CubicBezier& curve, double from, double to, double distanceFrom,
                            double distanceTo, const HalfPlane& plane);

/// The same for an arc of at most one turn; parameters are angles [rad].
ParameterRanges partsInside(const EllipticArc& arc, double from, double to, const HalfPlane& plane);

} // namespace chesil
