#pragma once

#include "core/base/pose.hpp"

namespace chesil::benchmark
{

/// libccd and Bullet know bodies in space only. What they get: A as a prism whose half height is the pair's
/// size, more than any depth in the plane, and B as a flat plate at half its height; so A - B is a prism
/// again and the shortest way out lies in the plane.
///
/// Straight to the side, both rims of A are equally far, and the answer is free. With `upperRim` both peers
/// tell contact from none in all pairs. With `middle` the search stays in one plane: both then see in half
/// the time that a pair is apart, but libccd misses a fifth of the shallow contacts and Bullet is far off in
/// many deep ones. Of what was tried besides (half heights of 1 to 100 sizes, B as thick as A, B shifted
/// along the height, libccd's own first direction), nothing is faster without being wrong more often, and
/// high prisms make libccd run for seconds.
enum class SidewaysSupport
{
    upperRim,
    middle,
};

struct PrismHeight
{
    double up = 0;
    double sideways = 0;

    /// Height [m] of the support point along a direction with this vertical component.
    double along(double vertical) const { return vertical > 0 ? up : vertical < 0 ? -up : sideways; }
};

inline PrismHeight heightOfA(double pairSize, SidewaysSupport sideways)
{
    return {pairSize, sideways == SidewaysSupport::upperRim ? pairSize : 0};
}

/// Support point of the plane shape. (0, 0), straight up or down, is no direction that our shapes know; any
/// point will do.
template <class ShapeType>
Vector2 planeSupport(const ShapeType& shape, double x, double y)
{
    return shape.support(x == 0 && y == 0 ? Vector2(1, 0) : Vector2(x, y));
}

} // namespace chesil::benchmark
