#pragma once

#include "core/base/tolerances.hpp"
#include "core/base/vector.hpp"

#include <cmath>

namespace chesil
{

/// Where a search looks first, of unit length: a remembered direction of any length; if that is zero the line of
/// centres, and any direction if they coincide.
template <int Dim>
Vector<Dim> firstNormal(const Vector<Dim>& remembered, const Vector<Dim>& centreToCentre)
{
    const double squaredLength = remembered.squaredNorm();
    if (std::abs(squaredLength - 1) <= tolerances::sameNormal)
    {
        return remembered;
    }
    if (squaredLength > 0)
    {
        return remembered / std::sqrt(squaredLength);
    }
    const double distance = centreToCentre.norm();
    return distance > 0 ? Vector<Dim>(centreToCentre / distance) : Vector<Dim>(Vector<Dim>::UnitX());
}

} // namespace chesil
