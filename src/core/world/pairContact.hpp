#pragma once

#include "core/base/pose.hpp"
#include "core/contact/contactGeometry.hpp"
#include "core/shapes/shape.hpp"

namespace chesil
{

/// How a pair query ended.
enum class PairStatus
{
    separated,
    overlapping,
    /// Overlapping, with a depth that EPA could not bring to its tolerance.
    coarse,
    /// GJK did not decide within its limit; counts as separated.
    undecided,
    /// A pose or shape holds a number that is not finite.
    notFinite,
};

/// Contact of two placed grains. `direction` is where to look first; on return the direction that separates
/// the pair, or the contact's normal: hand it back at the next step. `contact` is written if they overlap.
/// Disks meet disks by formula, all else through GJK and EPA.
PairStatus pairContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    Vector2& direction,
    ContactGeometry<2>& contact);

} // namespace chesil
