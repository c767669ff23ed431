#pragma once

#include "core/boundary/planeWall.hpp"
#include "core/contact/contactGeometry.hpp"
#include "core/narrowphase/searchStart.hpp"
#include "core/shapes/shape.hpp"

namespace chesil
{

/// Contact of a placed grain with a wall, by one support call; false if they do not overlap. The normal points from the
/// grain into the wall; flatContact splits that of a straight side.
bool wallContact(
    const Shape& shape, const Pose<2>& pose, const PlaneWall<2>& wall, SearchStart& start, ContactGeometry<2>& contact);

} // namespace chesil
