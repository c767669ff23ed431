#pragma once

#include "core/base/vector.hpp"

#include <cstddef>
#include <vector>

namespace chesil
{

/// A sharp corner of a convex hull: a joint of the outline with a range of normals.
struct HullCorner
{
    Vector2 position;
    /// The hull's vertices `first` to `last` (past the end of the list: minus its size) turn here.
    std::size_t first;
    std::size_t last;
    /// Turn over these vertices [rad].
    double turn;
};

/// The corners of a convex polygon, given counter-clockwise, in its order: where it turns by 45 to 140
/// degrees within 3 pixels, and those are 85 % or more of its turn within 9 pixels on both sides. What is
/// sharper is a tip, which is no wider than a pixel. Only of polygons 200 pixels long (60 across) or longer:
/// of smaller grains, pixels cannot tell a corner from a bend that counts. `pixel`: in units of the polygon;
/// 0 finds none.
std::vector<HullCorner> hullCorners(const std::vector<Vector2>& polygon, double pixel);

} // namespace chesil
