#pragma once

#include "core/base/pose.hpp"
#include "core/contact/contactGeometry.hpp"
#include "core/narrowphase/penetration.hpp"
#include "core/shapes/shape.hpp"

namespace chesil
{

/// Contact of two placed grains. `direction` is where to look first (zero: along the line of centres); on return
/// the direction that separates the pair, or the contact's normal: hand it back at the next step. `contact` is
/// written if they overlap; flatContact splits that of two straight sides.
/// Disks and polygons by formula, other shapes by their nearest valley, those without
/// curvature by GJK and EPA: doc/contactKernel.md.
PairStatus pairContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    Vector2& direction,
    ContactGeometry<2>& contact);

/// The same, and what it cost.
PairStatus pairContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    Vector2& direction,
    ContactGeometry<2>& contact,
    QueryCost& cost);

} // namespace chesil
