#pragma once

#include "core/base/vector.hpp"

namespace chesil
{

/// Vectors that lie in a contact's tangent plane, by their components there: it turns with the contact, and what is
/// carried from step to step needs no turning.
template <int Dim>
struct TangentPlane;

/// A line, along the normal turned by +90 degrees.
template <>
struct TangentPlane<2>
{
    using Vector = double;

    static double of(const Vector2& vector, const Vector2& normal) { return cross(normal, vector); }
    static Vector2 inWorld(double tangential, const Vector2& normal) { return tangential * perpendicular(normal); }
    static double dot(double a, double b) { return a * b; }
    static double norm(double a) { return std::abs(a); }
};

template <int Dim>
using Tangential = typename TangentPlane<Dim>::Vector;

} // namespace chesil
