#pragma once

#include "core/base/vector.hpp"

namespace chesil
{

/// Where and how two bodies overlap, world frame.
template <int Dim>
struct ContactGeometry
{
    /// Overlap [m], > 0.
    double depth;
    /// Unit normal, from the first body to the second.
    Vector<Dim> normal;
    /// Middle of the overlap [m].
    Vector<Dim> point;
};

} // namespace chesil
