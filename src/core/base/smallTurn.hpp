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
    const double versine = 0.5 * square * (1 - (1.0 / 12) * square * (1 - (1.0 / 30) * square));
    const double sine = angle * (1 - (1.0 / 6) * square * (1 - (1.0 / 20) * square));
    return vector - versine * vector + sine * perpendicular(vector);
}

} // namespace chesil
