#pragma once

#include "core/shapes/shape.hpp"

#include <optional>

namespace chesil
{

/// Direction in which a shape is longest [rad], in its own frame, in (-pi/2, pi/2]: that of the largest second moment
/// of its area, the long axis of the ellipse with the same second moments. Unlike the largest Feret diameter, which
/// jumps between the corners of a brick, it moves smoothly with the outline. Nothing for shapes whose moments are alike in all
/// directions (disks, regular polygons), to tolerances::isotropic.
std::optional<double> longAxis(const Shape& shape);

} // namespace chesil
