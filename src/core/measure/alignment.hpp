#pragma once

#include "core/measure/axialData.hpp"

#include <optional>
#include <vector>

namespace chesil
{

/// How far grains' long axes point the same way, from their angles [rad] in the world, any turns: the mean of
/// (cos 2t, sin 2t). Its amplitude is the nematic order parameter S of the plane, 0 for no order (or for
/// crossed groups of equal size), 1 if all axes are parallel; its direction is the director (de Gennes &
/// Prost 1993, section 2.1). Nothing without axes. The rose of the same angles: `roseHistogram`.
std::optional<SecondHarmonic> alignment(const std::vector<double>& axisAngles);

} // namespace chesil
