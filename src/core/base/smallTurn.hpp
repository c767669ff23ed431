#pragma once

#include "core/base/vector.hpp"

namespace chesil
{

/// Most that turnedBy takes [rad].
constexpr double smallTurn = 1e-2;

/// A vector turned counter-clockwise by an angle of at most smallTurn [rad], to rounding: by the series of cosine and
/// sine.
inline Vector2 turnedBy(double angle, const Vector2& vector)
{
    const double square = angle * angle;
    const double versine = square / 2 * (1 - square / 12 * (1 - square / 30));
    return vector - versine * vector + angle * (1 - square / 6 * (1 - square / 20)) * perpendicular(vector);
}

} // namespace chesil
