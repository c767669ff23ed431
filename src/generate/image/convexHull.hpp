#pragma once

#include "core/base/vector.hpp"
#include "generate/image/silhouette.hpp"

#include <vector>

namespace chesil
{

/// The convex hull of a silhouette in its frame [pixel], as a polygon, counter-clockwise, that has no bias in
/// area: the hull of the dark pixels' centres with each edge moved outward by half the distance to the next
/// row of pixel centres parallel to it, that is by 1 / (2 sqrt(p^2 + q^2)) for an edge of k steps (p, q).
///
/// Why: a pixel is dark if its centre lies in the grain, so that a grain's straight side lies anywhere
/// between the last row of centres inside and the first one outside. By Pick's theorem the hull of the
/// centres lacks half of the centres on it, and the moved edges add 1/2 a centre: the area becomes the number
/// of pixels of the hull (less 1, plus the corners). Hulls of the pixels' corners and of their edges'
/// midpoints are too large; doc/grainFit.md shows by how much.
///
/// The pixels with their centre in the polygon are those of the hull of the centres. A silhouette one pixel
/// wide gives a strip one pixel wide.
std::vector<Vector2> convexOutline(const Silhouette& silhouette);

/// The hull of the silhouette's outline() where the image's grey values tell one, else convexOutline.
std::vector<Vector2> finestHull(const Silhouette& silhouette);

/// Vertices of the convex hull, counter-clockwise, no three of them on a line.
std::vector<Vector2> convexHull(const std::vector<Vector2>& points);

/// Area of a polygon, positive if counter-clockwise.
double polygonArea(const std::vector<Vector2>& vertices);

/// Centroid of a polygon of positive area.
Vector2 polygonCentroid(const std::vector<Vector2>& vertices);

/// Integral of x x^T over a polygon of positive area, x from its centroid, by its area.
Eigen::Matrix2d polygonCovariance(const std::vector<Vector2>& vertices);

/// The polygon of the largest area with (at most) `count` of a convex polygon's vertices. Work: count times
/// the cube of the number of vertices.
std::vector<Vector2> largestInscribed(const std::vector<Vector2>& polygon, int count);

} // namespace chesil
