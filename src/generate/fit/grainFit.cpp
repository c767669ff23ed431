#include "generate/fit/grainFit.hpp"

#include "core/base/setupError.hpp"
#include "generate/fit/convexHull.hpp"
#include "generate/fit/pixelRegion.hpp"
#include "generate/fit/smoothOutline.hpp"

#include <chrono>
#include <cmath>

namespace chesil
{

namespace
{

/// Chords of the fitted outline leave it by at most this much [pixel] when areas are compared.
constexpr double chordTolerance = 1e-3;

std::vector<CubicBezier> magnified(std::vector<CubicBezier> segments, double scale)
{
    for (CubicBezier& segment : segments)
    {
        segment = segment.transformed(Vector2::Zero(), 1, 0, scale);
    }
    return segments;
}

void moveBy(std::vector<Vector2>& points, const Vector2& step)
{
    for (Vector2& point : points)
    {
        point += step;
    }
}

void check(const std::string& imagePath, const FitSettings& settings)
{
    if (settings.segments < fewestSegments || settings.segments > mostSegments)
    {
        throw SetupError(imagePath, "segments", std::to_string(settings.segments),
                         std::to_string(fewestSegments) + " to " + std::to_string(mostSegments));
    }
    if (!(std::isfinite(settings.scale) && settings.scale > 0))
    {
        throw SetupError(imagePath, "scale", numberText(settings.scale), "the size of a pixel, > 0");
    }
}

/// About `centre`, as `hull` is.
std::vector<CubicBezier> fittedOutline(const Silhouette& silhouette, const std::vector<Vector2>& hull,
                                       const Vector2& centre, const FitSettings& settings)
{
    if (settings.method == FitMethod::swarm)
    {
        std::vector<Vector2> inFrame = hull;
        moveBy(inFrame, centre);
        std::vector<CubicBezier> outline = fitBySwarm(silhouette, inFrame, settings.segments, settings.swarm);
        for (CubicBezier& segment : outline)
        {
            segment = segment.transformed(-centre, 1, 0, 1);
        }
        return outline;
    }
    return settings.joints == JointSpacing::equal
               ? fitAtJoints(hull, JointPlan::equal(settings.segments)).value().segments
               : fitWithCorners(hull, settings.segments, 1).segments;
}

} // namespace

GrainFit fitGrain(const Silhouette& silhouette, const FitSettings& settings)
{
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    std::vector<Vector2> hull = convexOutline(silhouette);
    // About its own centre, since rounding grows with the distance from the origin.
    const Vector2 centre = polygonCentroid(hull);
    moveBy(hull, -centre);
    const std::vector<CubicBezier> fitted = fittedOutline(silhouette, hull, centre, settings);
    GrainFit fit{PolyBezier(magnified(fitted, settings.scale))};
    fit.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();

    fit.centroid = fit.grain.givenCentroid() + settings.scale * (centre + silhouette.corner());
    fit.pixels = silhouette.count();
    std::vector<Vector2> outline = outlinePoints(Outline(fitted.begin(), fitted.end()), chordTolerance);
    moveBy(outline, centre);
    moveBy(hull, centre);
    const PixelRegion area(outline);
    fit.accuracySilhouette = fitAccuracy(area, PixelRegion(silhouette));
    fit.accuracyHull = fitAccuracy(area, PixelRegion(hull));
    return fit;
}

std::vector<GrainFit> fitGrains(const std::string& imagePath, const ImageGrains& image,
                                const FitSettings& settings)
{
    check(imagePath, settings);
    std::vector<GrainFit> fits;
    for (const Silhouette& silhouette : image.grains)
    {
        try
        {
            fits.push_back(fitGrain(silhouette, settings));
        }
        catch (const ValueError& error)
        {
            throw error.at(imagePath, grainName(fits.size()));
        }
    }
    return fits;
}

std::string grainName(std::size_t index) { return "grain" + std::to_string(index + 1); }

} // namespace chesil
