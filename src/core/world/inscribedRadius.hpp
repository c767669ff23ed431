#pragma once

#include "core/shapes/shape.hpp"

namespace chesil
{

/// Radius of the largest disk about the centroid that fits into the shape [m], to a thousandth: the least support over
/// directions half a degree apart, with one that no sampling error can make too large.
double inscribedRadius(const Shape& shape);

} // namespace chesil
