#pragma once

#include "core/base/vector.hpp"

#include <cmath>

namespace chesil
{

/// Counter-clockwise arc of an ellipse: centre + cos(a) axisA + sin(a) axisB, a from `from` to `to` [rad],
/// with perpendicular half-axis vectors [m], axisB counter-clockwise of axisA.
struct EllipticArc
{
    Vector2 centre = Vector2::Zero();
    Vector2 axisA = Vector2::UnitX();
    Vector2 axisB = Vector2::UnitY();
    double from = 0;
    double to = 0;

    Vector2 at(double angle) const { return centre + std::cos(angle) * axisA + std::sin(angle) * axisB; }
};

} // namespace chesil
