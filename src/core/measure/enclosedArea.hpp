#pragma once

#include "core/base/vector.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace chesil
{

/// Area of the intersection of half-planes [m2], each given by a point and the normal into it; nothing if it is not bounded or
/// empty.
std::optional<double> enclosedArea(const std::vector<std::pair<Vector2, Vector2>>& halfPlanes);

} // namespace chesil
