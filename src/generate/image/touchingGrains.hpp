#pragma once

#include "generate/image/silhouette.hpp"

#include <vector>

namespace chesil
{

/// Share of the convex hull's area that the grain covers: 1 convex; hull by convexOutline of its pixels.
double convexity(const Silhouette& silhouette);

/// A silhouette of less convexity than `convexityOfOne` is looked at for grains that touch. It is cut where
/// the neck is less than `neckWidth` of the width of the thinner of the two parts. Parts that are thinner
/// than `bumpWidth` of the thickest are bumps of it, parts of fewer pixels than `minPixels` belong to their
/// neighbour.
struct TouchCriterion
{
    double convexityOfOne = 0.95;
    double neckWidth = 0.6;
    double bumpWidth = 0.2;
    int minPixels = 200;
};

/// The grains that a silhouette seems to be made of, in the order of their first pixels from the top; one if
/// it is a single grain. Each pixel goes to one part: watersheds of the distance from the ground (half the
/// sum of Leptonica's city-block and chessboard distances, which is within 8 % of the Euclidean one; its own
/// watersheds know absolute depths only). Parts have no outline().
std::vector<Silhouette> partsAtNecks(const Silhouette& silhouette, const TouchCriterion& criterion = {});

} // namespace chesil
