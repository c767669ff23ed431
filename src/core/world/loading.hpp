#pragma once

#include "core/world/placement.hpp"

#include <vector>

namespace chesil
{

/// What laboratory tests load a sample with. The walls of isotropic and biaxial loading have the same names
/// in the same order, left, right, floor, lid, so that the state of one goes on under the other. World frame.

/// Servo walls along the four sides of a box, each pressed [Pa > 0] over the distance of its two neighbours,
/// at no more than `speed` [m/s > 0]. They carry no weight: without gravity only. ValueError for a box that
/// has no extent, or a pressure or speed that is not positive and finite.
std::vector<PlaneWall<2>> isotropicCompression(const PlacementBox& box, double pressure, double speed);

/// Left and right under the confining pressure [Pa > 0], at no more than `servoSpeed` [m/s > 0]; floor and
/// lid approach each other at the strain rate [1/s], of the height that they have at the time (logarithmic
/// strain; negative: they part). ValueError as above, and for a rate that is not finite.
std::vector<PlaneWall<2>> biaxialCompression(const PlacementBox& box, double confiningPressure,
                                             double servoSpeed, double axialStrainRate);

/// The box as a periodic cell in which v_x changes along y by `shearRate` [1/s]. ValueError for a box that
/// has no extent or a rate that is not finite.
StrainedCell simpleShear(const PlacementBox& box, double shearRate);

} // namespace chesil
