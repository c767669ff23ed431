#pragma once

#include <Eigen/Core>

#include <cmath>

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

/// a scaled to unit length; a must not be zero. One division, unlike Eigen's normalized().
inline Vector2 unit(const Vector2& a)
{
    return a * (1 / std::sqrt(a.x() * a.x() + a.y() * a.y()));
}

} // namespace chesil
