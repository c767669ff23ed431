#pragma once

#include "core/base/vector.hpp"
#include "core/geometry/cubicBezier.hpp"

#include <vector>

namespace chesil
{

/// Integrals over a plane region: of 1 [m2], of the position [m3] and of |position|^2 [m4], about the
/// origin of the frame that the boundary is given in.
struct AreaMoments
{
    double area = 0;
    Vector2 first = Vector2::Zero();
    double polar = 0;

    AreaMoments& operator+=(const AreaMoments& other);

    Vector2 centroid() const { return first / area; }

    /// Integral of the squared distance from the centroid [m4] (Steiner's rule).
    double polarAboutCentroid() const { return polar - first.squaredNorm() / area; }
};

/// What one boundary segment adds to the moments of the region on its left, by Green's theorem:
///   area = 1/2 int x cross dx,  first = 1/3 int x (x cross dx),  polar = 1/4 int |x|^2 (x cross dx).
/// The integrands are polynomials of degree 5, 8 and 11 at most, so that
/// Gauss's rule with 6 points is exact. Replaces the interpolated polygon of Lai & Huang, section 2.3.
AreaMoments boundaryMoments(const CubicBezier& segment);

/// Moments of the region inside a closed counter-clockwise chain of segments.
AreaMoments regionMoments(const std::vector<CubicBezier>& boundary);

} // namespace chesil
