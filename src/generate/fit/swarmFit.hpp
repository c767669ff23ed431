#pragma once

#include "core/geometry/cubicBezier.hpp"
#include "generate/fit/particleSwarm.hpp"
#include "generate/image/silhouette.hpp"

#include <vector>

namespace chesil
{

/// Fits an outline to a silhouette as Lai & Huang, section 4, do: the joints are the support points of
/// equally spaced directions on the convex outline `hull`, their tangent lines are square to these, and of
/// each segment the lengths x1 = |Q0 Q1| and x2 = |Q2 Q3|, up to the crossing R of the tangent lines, are
/// found by a particle swarm on the number of pixels that the segment gets wrong (those of the triangle Q0 R
/// Q3: no other one can change).
///
/// What the paper leaves open: a direction square to a side of the hull has its support point in the middle
/// of the side; directions with one and the same support point make it a corner, a joint with a range of
/// normals, and no segment between them. The outline has then fewer segments. A joint on its neighbour's
/// tangent line makes the segment straight.
///
/// `hull`: in the silhouette's frame, as are the segments. Throws ValueError if the number of segments is not
/// within [fewestSegments, mostSegments].
std::vector<CubicBezier> fitBySwarm(const Silhouette& silhouette, const std::vector<Vector2>& hull,
                                    int segments, const SwarmSettings& settings = {});

} // namespace chesil
