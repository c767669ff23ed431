#pragma once

#include "core/geometry/outline.hpp"

#include <Eigen/Core>

namespace chesil
{

/// Integral of x (x) x over the region inside a closed outline [m4], about the origin of its frame, by Green's theorem:
/// 1/4 int x (x) x (x cross dx) along the boundary. Exact for cubic segments, to rounding for arcs.
Eigen::Matrix2d secondMoments(const Outline& outline);

} // namespace chesil
