#pragma once

#include "core/shapes/shape.hpp"

namespace chesil
{

/// The shape with all lengths times `scale`, about its centroid. Throws ValueError unless the result has a
/// size that shapes may have (requireSize).
Shape scaled(const Shape& shape, double scale);

/// The shape scaled to a size [m] by size / diameterOf(original), named "<name> of size <size> m": the same original and
/// size give the same bits. Throws as scaled.
NamedShape ofSize(const NamedShape& original, double size);

} // namespace chesil
