#pragma once

#include "core/base/vector.hpp"

#include <cmath>

namespace chesil
{

/// Most that any point of a grain's outline may move in a step [m], so that no contact is leapt over: half the radius
/// of a disk about the centroid that lies within the grain [m].
///
/// In the frame of one grain the other then moves by at most half the sum of both radii. Two that are apart before and
/// after a step have been at most half of that way inside each other, since one of the two ends is as near: what a step
/// can miss is a graze of a quarter of the two radii. A half-plane is never leapt over: its contact reaches down
/// without end.
inline double mostTravel(double innerRadius)
{
    return innerRadius / 2;
}

/// Most that two grains may come into each other [m] before they count as passing through; `way` is that of one against
/// the other in a step [m]. When the centroids meet, the depth is at least the sum of both radii [m], and the step next to
/// that moment sees it shallower by half of its way at most.
inline double mostDepth(double sumOfInnerRadii, double way)
{
    return sumOfInnerRadii - way / 2;
}

} // namespace chesil
