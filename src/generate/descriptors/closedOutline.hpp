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

/// Of an outline of equal steps: each point the mean of its neighbours weighed by a Gaussian of this standard deviation, in steps.
ClosedOutline smoothed(const ClosedOutline& outline, double deviation);

} // namespace chesil
