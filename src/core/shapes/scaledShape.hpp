#pragma once

#include "core/shapes/shape.hpp"

namespace chesil
{

/// The shape with all lengths times `scale`, about its centroid. Throws ValueError unless the result has a
/// size that shapes may have (requireSize).
Shape scaled(const Shape& shape, double scale);

} // namespace chesil
