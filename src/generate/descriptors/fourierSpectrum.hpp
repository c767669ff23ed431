#pragma once

#include "generate/descriptors/closedOutline.hpp"

#include <optional>
#include <vector>

namespace chesil
{

/// Normalised amplitudes D_0 = 1, D_1, ... D_64 of the outline's distance from its centroid at 128 equal angles, the first along
/// `firstRay` (Mollon & Zhao 2012, eqs. 5 to 9, with the argument n theta_i and the factor 2/N of a real series). None if some
/// ray from the centroid meets the outline more than once.
std::optional<std::vector<double>> fourierSpectrum(const ClosedOutline& outline, const Vector2& firstRay);

} // namespace chesil
