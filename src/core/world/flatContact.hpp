#pragma once

#include "core/boundary/planeWall.hpp"
#include "core/contact/contactGeometry.hpp"
#include "core/shapes/shape.hpp"

#include <array>

namespace chesil
{

/// How one place of several takes part in a contact. Its depth grows as the first body moves against the second by
/// weight (d . normal) + d . depthPerWay, d being the way of the contact's point, and by depthPerTurn times the turn about it.
struct PlaceShare
{
    /// Places that share the mass to be damped, each counted by its weight.
    double sharing = 1;
    double weight = 1;
    Vector2 depthPerWay = Vector2::Zero();
    /// [m/rad].
    double depthPerTurn = 0;
};

/// One end of two straight sides that touch, world frame.
struct FlatGeometry : ContactGeometry<2>
{
    PlaceShare share;
};

/// Whether a shape may touch at two places: it has straight sides.
bool hasStraightSides(const Shape& shape);

/// The two places of a contact that pairContact has found, if two straight sides touch; else false. In the order of
/// perpendicular(contact.normal); an end that hangs free has a depth <= 0. doc/contactKernel.md, "Flat contacts".
bool flatContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    const ContactGeometry<2>& contact,
    std::array<FlatGeometry, 2>& places);

/// The same for a grain and a wall that wallContact has found to overlap.
bool flatContact(
    const Shape& shape,
    const Pose<2>& pose,
    const PlaneWall<2>& wall,
    const ContactGeometry<2>& contact,
    std::array<FlatGeometry, 2>& places);

} // namespace chesil
