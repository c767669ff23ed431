#pragma once

#include "generate/descriptors/closedOutline.hpp"

namespace chesil
{

/// Width of an outline between two parallel lines.
struct LeastWidth
{
    /// The smallest of all directions, and that at right angles to it.
    double width;
    double length;
    /// Unit, along the length.
    Vector2 longAxis;
};

/// Rotating callipers: exact, since the least width stands at right angles to a side. `hull`: convex, counter-clockwise.
LeastWidth leastWidth(const ClosedOutline& hull);

} // namespace chesil
