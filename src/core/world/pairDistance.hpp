#pragma once

#include "core/world/pairContact.hpp"

namespace chesil
{

/// Signed distance of two placed grains, world frame [m].
struct PairDistance
{
    /// separated or overlapping, unless it failed.
    PairStatus status;
    /// Negative: how deep they overlap.
    double distance;
    /// Unit, from A to B.
    Vector2 normal;
    /// The two points nearest to each other, or deepest in each other: onB - onA = distance * normal.
    Vector2 onA;
    Vector2 onB;
};

/// Distance of any two grains, near or far. `direction` is where to look first (zero: along the line of centres).
PairDistance pairDistance(
    const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB, const Vector2& direction = Vector2::Zero());

} // namespace chesil
