#pragma once

#include "core/base/tolerances.hpp"
#include "core/base/vector.hpp"

#include <vector>

namespace chesil
{

/// Checks that a closed polygon turns counter-clockwise once and never inward; repeated vertices are
/// skipped. Throws ValueError that says what is wrong and at which vertex: not finite, fewer than three
/// distinct vertices, clockwise, an inward turn, a turn back on itself (flat, or a spike), or crossing itself
/// (turning more than once).
/// An inward turn of up to `allowedTurn` [rad] passes.
void requireConvex(const std::vector<Vector2>& vertices, double allowedTurn = tolerances::convexity);

} // namespace chesil
