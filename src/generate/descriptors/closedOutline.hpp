#pragma once

#include "core/base/vector.hpp"

#include <vector>

namespace chesil
{

/// A simple closed polygon, counter-clockwise, the first vertex not repeated; any unit of length.
using ClosedOutline = std::vector<Vector2>;

double perimeterOf(const ClosedOutline& outline);

/// `count` points at equal steps along the outline, from its first vertex on.
ClosedOutline resampled(const ClosedOutline& outline, std::size_t count);

/// Of an outline of equal steps: each point the mean of its neighbours, weighed by (3 - u^2)/2 times a Gaussian, u being the distance
/// over `deviation`, in steps. The second moment of these weights is zero: an arc keeps its radius to the fourth power
/// of the deviation, where a Gaussian would shrink it by the square.
ClosedOutline smoothed(const ClosedOutline& outline, double deviation);

} // namespace chesil
