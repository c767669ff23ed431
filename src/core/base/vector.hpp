#pragma once

#include <Eigen/Core>

namespace chesil
{

/// Point, direction or force in Dim dimensions. Units and frame stand beside each use.
template <int Dim>
using Vector = Eigen::Matrix<double, Dim, 1>;

using Vector2 = Vector<2>;

/// The out-of-plane component of a x b; positive if b lies counter-clockwise of a.
inline double cross(const Vector2& a, const Vector2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// a turned by +90 degrees.
inline Vector2 perpendicular(const Vector2& a)
{
    return Vector2(-a.y(), a.x());
}

} // namespace chesil
