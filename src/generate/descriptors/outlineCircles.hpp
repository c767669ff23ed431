#pragma once

#include "generate/descriptors/closedOutline.hpp"

namespace chesil
{

struct OutlineCircle
{
    Vector2 centre;
    double radius;
};

/// The smallest circle around all points (CGAL).
OutlineCircle circumscribedCircle(const ClosedOutline& points);

/// The largest circle within the outline. Found to 1e-4 of its radius by halving squares that may hold its centre (the largest
/// distance from the edge within a square is at most that of its centre plus half its diagonal), then moved uphill by
/// linear programmes on the nearest points of the edge all around until it touches in three places, or two opposite ones:
/// rounding is left, unless another place is as good within 1e-4.
OutlineCircle inscribedCircle(const ClosedOutline& outline);

} // namespace chesil
