#pragma once

#include "generate/fit/smoothOutline.hpp"

#include <functional>
#include <vector>

namespace chesil
{

/// An outline with the polygon's corners (see hullCorners), unless it is further from the polygon than 0.1
/// pixels and than a smooth one, which then is taken. Throws as fitSmoothOutline does.
OutlineFit fitWithCorners(const std::vector<Vector2>& polygon, int segments, double pixel);

/// The fit with the fewest segments found that `isGoodEnough` accepts, or else the nearer one of `most`
/// segments. Starts with JointPlan::coarsest; splits the segment with the largest area between it and the
/// polygon, and tries fitWithCorners with as many segments, too. Throws as fitSmoothOutline does.
OutlineFit fitToAccuracy(const std::vector<Vector2>& polygon, int most, double pixel,
                         const std::function<bool(const std::vector<CubicBezier>&)>& isGoodEnough);

} // namespace chesil
