#pragma once

#include "core/base/vector.hpp"

#include <cmath>

namespace chesil
{

/// Most that any point of a grain's outline may move in a step [m], so that no contact is leapt over: half the radius
/// of the largest disk about the centroid that fits into the grain [m].
///
/// In the frame of one grain the other then moves by at most half the sum of both radii. Two that are apart before and
/// after a step have been at most half of that way inside each other, since one of the two ends is as near: what a step
/// can miss is a graze of a quarter of the two radii. A half-plane is never leapt over: its contact reaches down
/// without end.
inline double mostTravel(double inscribedRadius)
{
    return inscribedRadius / 2;
}

/// Most that two grains may be inside each other [m] before they count as passing through: three quarters of the sum of
/// both radii [m]. When the centroids meet, the depth is at least that sum, and mostTravel lets a step see it at least
/// this deep on the way.
inline double mostDepth(double inscribedRadius, double other)
{
    return 0.75 * (inscribedRadius + other);
}

/// How far the outline moves in a step [m], at most; not a number if the velocities are not.
inline double travel(const Vector2& velocity, double angularVelocity, double boundingRadius, double timeStep)
{
    return timeStep * (velocity.norm() + std::abs(angularVelocity) * boundingRadius);
}

} // namespace chesil
