#pragma once

#include "core/geometry/areaMoments.hpp"
#include "core/geometry/cubicBezier.hpp"
#include "core/shapes/massProperties.hpp"

#include <vector>

namespace chesil
{

/// A closed boundary about its centroid, and what was found on the way.
struct CentredBoundary
{
    std::vector<CubicBezier> segments;
    /// The centroid in the frame of the segments given [m].
    Vector2 givenCentroid = Vector2::Zero();
    MassProperties mass;
};

/// Moves a closed counter-clockwise boundary to its centroid. One that is there already, to rounding, is
/// kept to the bit, so that a template read from file and written again is the same file.
CentredBoundary centred(const std::vector<CubicBezier>& segments);

} // namespace chesil
