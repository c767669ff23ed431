#pragma once

#include "core/shapes/shape.hpp"
#include "generate/descriptors/closedOutline.hpp"
#include "generate/descriptors/outlineCircles.hpp"
#include "generate/image/silhouette.hpp"

#include <optional>
#include <vector>

namespace chesil
{

/// What is said of a grain's shape, doc/grainDescriptors.md. Lengths in the outline's unit, all else without one.
struct ShapeDescriptors
{
    double area;
    double perimeter;
    /// Of the circle of equal area.
    double equivalentDiameter;
    /// The largest circle inside and the smallest around.
    OutlineCircle inscribed;
    OutlineCircle circumscribed;
    /// Least width over the length at right angles to it (Mollon & Zhao 2012, eq. 1), and the angle of that length to the x axis,
    /// above -90 and up to 90 [degrees].
    double elongation;
    double elongationAngle;
    /// Root of inscribed over circumscribed diameter (eq. 3).
    double circularity;
    /// Equivalent over circumscribed diameter (Wadell 1933).
    double sphericity;
    /// Area over that of the convex hull.
    double convexity;
    /// log10 of the perimeter over its excess over the hull's (eq. 4); infinite for a convex outline.
    double regularity;
    /// Of all circles that cover the outline (eq. 2), and of the corners (Wadell 1932); roundness.hpp.
    double roundness;
    double cornerRoundness;
    /// D_0 to D_64 (eqs. 5 to 9); none if the grain is not star-shaped about its centroid.
    std::optional<std::vector<double>> spectrum;
};

/// Of an outline drawn as it is: no point of it is noise.
ShapeDescriptors describe(const ClosedOutline& outline);

/// How well the edge of an image's grain is known: by the grey values of mixed pixels, or by the pixels alone.
enum class EdgeAccuracy
{
    pixel,
    subPixel
};

EdgeAccuracy edgeAccuracy(const Silhouette& silhouette);

/// Of an outline from pixels of this size [outline's unit]: both roundnesses are those of the outline smoothed over
/// 0.4 % of the perimeter, 3 pixels at least (subPixel), or 1 % and 8 pixels (pixel), lest noise count as corners.
ShapeDescriptors describePixels(const ClosedOutline& outline, EdgeAccuracy accuracy, double pixel = 1);

/// Of a template, as a polygon that leaves it by at most 1e-7 of its size.
ShapeDescriptors describe(const Shape& shape);

/// The outline that describePixels asks for, in the silhouette's frame [pixel]: outline() where the image knows one, smoothed
/// over a pixel; else through the middles of the pixels' edges, smoothed over two, since stairs of pixels would lengthen it.
ClosedOutline outlineToDescribe(const Silhouette& silhouette);

} // namespace chesil
