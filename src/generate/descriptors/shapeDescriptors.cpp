#include "generate/descriptors/shapeDescriptors.hpp"

#include "core/geometry/outline.hpp"
#include "generate/descriptors/fourierSpectrum.hpp"
#include "generate/descriptors/leastWidth.hpp"
#include "generate/descriptors/outlineCircles.hpp"
#include "generate/descriptors/roundness.hpp"
#include "generate/image/convexHull.hpp"
#include "generate/image/subPixelOutline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

/// Chords of a template's curves, over its radius.
constexpr double chordTolerance = 1e-7;

/// Sides of a polygon longer than this are no chords of its curves, over the inscribed radius.
constexpr double straightSide = 2e-3;

/// Steps of an outline whose corners are looked for.
constexpr std::size_t cornerSteps = 2000;

/// Steps that a pixel's edge is cut in.
constexpr double stepsInPixel = 2;

/// Standard deviations of what smooths an outline [pixel], so that a shape turned and shifted in the image has the same
/// descriptors within 1e-3 at a sub-pixel edge; an edge along the pixels knows less.
struct Smoothing
{
    double outline;
    /// Of what corners are looked for in, besides: a share of the perimeter, so that an enlarged grain has the same corners,
    /// but so many pixels at least.
    double corners;
    double leastCorners;

    static Smoothing of(EdgeAccuracy accuracy)
    {
        return accuracy == EdgeAccuracy::subPixel ? Smoothing{1, 0.004, 3} : Smoothing{2, 0.01, 8};
    }
};

/// An outline whose perimeter exceeds the hull's by less than this share is convex: the rounding of some thousand sides.
constexpr double convexExcess = 1e-12;

double inDegrees(const Vector2& axis)
{
    const double angle = std::atan2(axis.y(), axis.x()) * 180 / M_PI;
    return angle > 90 ? angle - 180 : angle <= -90 ? angle + 180 : angle;
}

/// `smooth`: outline of pixels to look for corners in; null: the outline itself.
ShapeDescriptors describe(const ClosedOutline& outline, const ClosedOutline* smooth)
{
    const ClosedOutline hull = convexHull(outline);
    const LeastWidth least = leastWidth(hull);
    const OutlineCircle inscribed = inscribedCircle(outline);
    const OutlineCircle circumscribed = circumscribedCircle(hull);
    ShapeDescriptors found;
    found.area = polygonArea(outline);
    found.perimeter = perimeterOf(outline);
    found.equivalentDiameter = std::sqrt(4 * found.area / M_PI);
    found.inscribed = inscribed;
    found.circumscribed = circumscribed;
    found.elongation = least.width / least.length;
    found.elongationAngle = inDegrees(least.longAxis);
    found.circularity = std::sqrt(inscribed.radius / circumscribed.radius);
    found.sphericity = found.equivalentDiameter / (2 * circumscribed.radius);
    found.convexity = found.area / polygonArea(hull);
    const double excess = 1 - perimeterOf(hull) / found.perimeter;
    found.regularity = excess > convexExcess ? -std::log10(excess) : std::numeric_limits<double>::infinity();
    found.roundness = coverRoundness(smooth ? *smooth : outline, inscribed.radius);
    found.cornerRoundness = smooth
        ? cornerRoundness(*smooth, inscribed.radius, std::numeric_limits<double>::infinity())
        : cornerRoundness(outline, inscribed.radius, straightSide * inscribed.radius);
    found.spectrum = fourierSpectrum(outline, least.longAxis);
    return found;
}

} // namespace

ShapeDescriptors describe(const ClosedOutline& outline)
{
    return describe(outline, nullptr);
}

ShapeDescriptors describePixels(const ClosedOutline& outline, EdgeAccuracy accuracy, double pixel)
{
    const Smoothing smoothing = Smoothing::of(accuracy);
    const double steps = cornerSteps * std::max(smoothing.corners, smoothing.leastCorners * pixel / perimeterOf(outline));
    const ClosedOutline smooth = smoothed(resampled(outline, cornerSteps), steps);
    return describe(outline, &smooth);
}

ShapeDescriptors describe(const Shape& shape)
{
    return describe(outlinePoints(outline(shape), chordTolerance * boundingRadius(shape)));
}

EdgeAccuracy edgeAccuracy(const Silhouette& silhouette)
{
    return silhouette.outline().empty() ? EdgeAccuracy::pixel : EdgeAccuracy::subPixel;
}

ClosedOutline outlineToDescribe(const Silhouette& silhouette)
{
    const EdgeAccuracy accuracy = edgeAccuracy(silhouette);
    const ClosedOutline edges = accuracy == EdgeAccuracy::pixel ? pixelOutline(silhouette) : silhouette.outline();
    const auto steps = static_cast<std::size_t>(std::ceil(stepsInPixel * perimeterOf(edges)));
    return smoothed(resampled(edges, steps), stepsInPixel * Smoothing::of(accuracy).outline);
}

} // namespace chesil
