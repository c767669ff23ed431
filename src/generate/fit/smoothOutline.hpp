#pragma once

#include "core/base/vector.hpp"
#include "core/geometry/cubicBezier.hpp"
#include "generate/fit/jointPlan.hpp"

#include <optional>
#include <vector>

namespace chesil
{

/// Fits a smooth (G1) convex outline of cubic segments to a convex polygon, with joints where it needs them
/// (JointPlan::adapted, no corners).
///
/// Minimises the mean squared distance between curve and polygon over all offsets, joints and handles at once
/// (see JointFrame): Gauss-Newton with a logarithmic barrier that keeps every gap positive, so that each
/// iterate is convex and G1. A corner of the polygon becomes a tight bend: the shortest handle is
/// 1e-3 of the largest radius, which leaves joints G1 to 1e-12 in doubles if the polygon lies about the
/// origin.
///
/// `polygon`: counter-clockwise, convex, any units. The segments are in the same frame. Throws ValueError if
/// the number of segments is not within [fewestSegments, mostSegments] or the polygon has no area.
std::vector<CubicBezier> fitSmoothOutline(const std::vector<Vector2>& polygon, int segments);

struct OutlineFit
{
    std::vector<CubicBezier> segments;
    /// Root of its mean squared distance from the polygon, in the polygon's unit.
    double distance = 0;
    /// Area between each segment and the polygon, about, in units of the polygon's furthest vertex from its
    /// centroid, squared.
    std::vector<double> areas;
};

/// The same with joints of this plan, corners included. None if they leave no room for a convex outline: too
/// many of them at a sharp tip or along a straight side, or corners with normals that contradict each other.
std::optional<OutlineFit> fitAtJoints(const std::vector<Vector2>& polygon, const JointPlan& plan);

/// An outline without corners at adapted joints, evened until there is room for it.
OutlineFit fitWithoutCorners(const std::vector<Vector2>& polygon, JointPlan plan);

/// Throws ValueError unless there are [fewestSegments, mostSegments] of them and the polygon has an area.
void requireFittable(const std::vector<Vector2>& polygon, int segments);

/// The vertices of a convex polygon with so many sides (fewer where two fall together), fitted by the same
/// solver.
std::vector<Vector2> fitPolygon(const std::vector<Vector2>& polygon, int sides);

} // namespace chesil
