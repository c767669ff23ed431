#pragma once

#include "core/base/pose.hpp"
#include "core/contact/contactGeometry.hpp"
#include "core/narrowphase/penetration.hpp"
#include "core/narrowphase/searchStart.hpp"
#include "core/shapes/shape.hpp"

namespace chesil
{

/// Contact of two placed grains. `start` is where to look first (none: along the line of centres); on return the
/// direction that separates the pair, or the contact's normal and its turn: hand it back at the next step. `contact` is
/// written if they overlap; flatContact splits that of two straight sides.
/// Disks and polygons by formula, other shapes by their nearest valley, those without
/// curvature by GJK and EPA: doc/contactKernel.md.
PairStatus pairContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    SearchStart& start,
    ContactGeometry<2>& contact);

/// The same, and what it cost.
PairStatus pairContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    SearchStart& start,
    ContactGeometry<2>& contact,
    QueryCost& cost);

} // namespace chesil
