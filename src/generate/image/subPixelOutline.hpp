#pragma once

#include "generate/image/greyImage.hpp"
#include "generate/image/silhouette.hpp"

#include <vector>

namespace chesil
{

/// What tells grain from ground: grain is what is not beyond `level`, which no pixel's value hits.
struct GreyLevel
{
    double level = 0;
    bool lightGrains = false;

    /// Positive in the grain, negative in the ground; in grey values.
    double depth(int grey) const { return lightGrains ? grey - level : level - grey; }
};

/// The silhouette's outer edge: a polygon, counter-clockwise, in the silhouette's frame, one vertex for each pixel edge
/// between the grain and what lies around it. Its place across that edge is where the covered shares of four pixels in a row, two on each
/// side, put it, which is exact for a straight edge of an image that averages over its pixels; where these do
/// not fall from all grain to all ground (an edge that is blurred or meets another) by linear interpolation between the two pixels'
/// centres to the level (marching squares; Lorensen & Cline's case of a plane). Between pixels that are both grain (two parts of a
/// split one) the vertex is half way. Pixels that share a corner only are not joined.
///
/// Empty if the grey values know nothing finer than the pixels: if, at fewer than a quarter of the pixel
/// edges, either pixel is mixed, that is in the middle half between the grain's median and the ground's. Half
/// of the edges have one where pixels average what they cover, none where an image is drawn pixel by pixel;
/// then interpolation would put the edge by the threshold and not by the grain. `silhouette` must not touch
/// the image's border.
std::vector<Vector2> subPixelOutline(const GreyImage& image, const GreyLevel& level,
                                     const Silhouette& silhouette);

/// The same edge for an image drawn pixel by pixel: through the middles of the pixels' edges.
std::vector<Vector2> pixelOutline(const Silhouette& silhouette);

} // namespace chesil
