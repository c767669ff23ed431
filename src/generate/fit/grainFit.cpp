#include "generate/fit/grainFit.hpp"

#include "core/base/setupError.hpp"
#include "generate/fit/adaptedFit.hpp"
#include "generate/image/convexHull.hpp"
#include "generate/fit/pixelRegion.hpp"

#include <chrono>
#include <cmath>

namespace chesil
{

namespace
{

using Segments = std::vector<CubicBezier>;

/// Chords of the fitted outline leave it by at most this much [pixel] when areas are compared.
constexpr double chordTolerance = 1e-3;

std::vector<Vector2> movedBy(std::vector<Vector2> points, const Vector2& step)
{
    for (Vector2& point : points)
    {
        point += step;
    }
    return points;
}

Segments transformed(Segments segments, const Vector2& translation, double scale)
{
    for (CubicBezier& segment : segments)
    {
        segment = segment.transformed(translation, 1, 0, scale);
    }
    return segments;
}

/// A silhouette's finestHull about its own centre, since rounding grows with the distance from the
/// origin.
struct CentredHull
{
    explicit CentredHull(const Silhouette& silhouetteFitted) : silhouette(silhouetteFitted)
    {
        const std::vector<Vector2> hull = finestHull(silhouette);
        centre = polygonCentroid(hull);
        vertices = movedBy(hull, -centre);
    }

    double accuracy(const std::vector<Vector2>& fitted) const
    {
        return fitAccuracy(PixelRegion(movedBy(fitted, centre)), PixelRegion(movedBy(vertices, centre)));
    }

    const Silhouette& silhouette;
    Vector2 centre;
    std::vector<Vector2> vertices;
};

std::vector<Vector2> pointsOf(const Segments& segments)
{
    return outlinePoints(Outline(segments.begin(), segments.end()), chordTolerance);
}

/// The first of 3, 4, ... pieces that is good enough, else the most.
template <class Fit, class IsGoodEnough>
auto fewestPieces(int most, const Fit& fit, const IsGoodEnough& isGoodEnough)
{
    int pieces = fewestSegments;
    auto found = fit(pieces);
    while (pieces < most && !isGoodEnough(found))
    {
        found = fit(++pieces);
    }
    return found;
}

Segments equalOutline(const CentredHull& hull, int segments)
{
    return fitAtJoints(hull.vertices, JointPlan::equal(segments)).value().segments;
}

Segments swarmOutline(const CentredHull& hull, int segments, const SwarmSettings& settings)
{
    return transformed(fitBySwarm(hull.silhouette, movedBy(hull.vertices, hull.centre), segments, settings),
                       -hull.centre, 1);
}

Segments fittedOutline(const CentredHull& hull, const FitSettings& settings)
{
    const auto isGoodEnough = [&](const Segments& outline)
    { return hull.accuracy(pointsOf(outline)) >= settings.accuracy.value(); };
    if (settings.method == FitMethod::direct && settings.joints == JointSpacing::adapted)
    {
        return settings.accuracy ? fitToAccuracy(hull.vertices, settings.segments, 1, isGoodEnough).segments
                                 : fitWithCorners(hull.vertices, settings.segments, 1).segments;
    }
    const auto fit = [&](int segments)
    {
        return settings.method == FitMethod::swarm ? swarmOutline(hull, segments, settings.swarm)
                                                   : equalOutline(hull, segments);
    };
    return settings.accuracy ? fewestPieces(settings.segments, fit, isGoodEnough) : fit(settings.segments);
}

/// Enlarged about its centroid.
std::vector<Vector2> withArea(std::vector<Vector2> polygon, double area)
{
    const Vector2 centroid = polygonCentroid(polygon);
    const double growth = std::sqrt(area / polygonArea(polygon));
    for (Vector2& vertex : polygon)
    {
        vertex = centroid + growth * (vertex - centroid);
    }
    return polygon;
}

std::vector<Vector2> fittedPolygon(const CentredHull& hull, const FitSettings& settings)
{
    const auto fit = [&](int sides)
    {
        const std::vector<Vector2> inscribed =
            withArea(largestInscribed(hull.vertices, sides), polygonArea(hull.vertices));
        const std::vector<Vector2> nearest = fitPolygon(hull.vertices, sides);
        return nearest.size() > 2 && hull.accuracy(nearest) > hull.accuracy(inscribed) ? nearest : inscribed;
    };
    const auto isGoodEnough = [&](const std::vector<Vector2>& polygon)
    { return hull.accuracy(polygon) >= settings.accuracy.value(); };
    return settings.accuracy ? fewestPieces(settings.segments, fit, isGoodEnough) : fit(settings.segments);
}

/// The grain, and its outline in pixels about the hull's centre.
struct Fitted
{
    GrainFit fit;
    std::vector<Vector2> points;
};

Fitted fittedPolyBezier(const CentredHull& hull, const FitSettings& settings)
{
    const Segments outline = fittedOutline(hull, settings);
    const PolyBezier grain(transformed(outline, Vector2::Zero(), settings.scale));
    Fitted fitted{GrainFit{grain}, pointsOf(outline)};
    fitted.fit.segments = static_cast<int>(outline.size());
    fitted.fit.centroid = grain.givenCentroid();
    return fitted;
}

Fitted fittedConvexPolygon(const CentredHull& hull, const FitSettings& settings)
{
    std::vector<Vector2> vertices = fittedPolygon(hull, settings);
    const std::vector<Vector2> points = vertices;
    for (Vector2& vertex : vertices)
    {
        vertex *= settings.scale;
    }
    const ConvexPolygon grain(vertices);
    Fitted fitted{GrainFit{grain}, points};
    fitted.fit.segments = static_cast<int>(vertices.size());
    fitted.fit.centroid = grain.givenCentroid();
    return fitted;
}

/// Of an ellipse, the covariance is a quarter of the squared half-axes.
Fitted fittedEllipse(const CentredHull& hull, const FitSettings& settings)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(polygonCovariance(hull.vertices));
    const Vector2 halfAxes = 2 * axes.eigenvalues().reverse().cwiseSqrt();
    const Vector2 longAxis = axes.eigenvectors().col(1);
    // Turned by -90 to 90 degrees
    const double angle = std::atan(longAxis.y() / longAxis.x());
    const Ellipse inPixels(halfAxes.x(), halfAxes.y());
    const Vector2 scaled = settings.scale * halfAxes;
    Fitted fitted{GrainFit{Ellipse(scaled.x(), scaled.y())}, {}};
    fitted.points = outlinePoints(placed(inPixels.outline(), Pose<2>{Vector2::Zero(), Rotation<2>(angle)}),
                                  chordTolerance);
    fitted.fit.segments = 1;
    fitted.fit.angle = angle;
    return fitted;
}

Fitted fitted(const CentredHull& hull, const FitSettings& settings)
{
    switch (settings.model)
    {
    case GrainModel::polygon:
        return fittedConvexPolygon(hull, settings);
    case GrainModel::ellipse:
        return fittedEllipse(hull, settings);
    default:
        return fittedPolyBezier(hull, settings);
    }
}

void check(const std::string& imagePath, const FitSettings& settings)
{
    const auto require =
        [&](bool right, const char* name, const std::string& found, const std::string& wanted)
    {
        if (!right)
        {
            throw SetupError(imagePath, name, found, wanted);
        }
    };
    require(settings.segments >= fewestSegments && settings.segments <= mostSegments, "segments",
            std::to_string(settings.segments),
            std::to_string(fewestSegments) + " to " + std::to_string(mostSegments));
    require(std::isfinite(settings.scale) && settings.scale > 0, "scale", numberText(settings.scale),
            "the size of a pixel, > 0");
    const double accuracy = settings.accuracy.value_or(0.5);
    require(accuracy > 0 && accuracy < 1, "accuracy", numberText(accuracy), "between 0 and 1");
    require(settings.swarm.particles > 0, "particles", std::to_string(settings.swarm.particles), "> 0");
    require(settings.swarm.iterations >= 0, "iterations", std::to_string(settings.swarm.iterations), ">= 0");
}

} // namespace

GrainFit fitGrain(const Silhouette& silhouette, const FitSettings& settings)
{
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const CentredHull hull(silhouette);
    auto [fit, points] = fitted(hull, settings);
    fit.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();

    fit.centroid += settings.scale * (hull.centre + silhouette.corner());
    fit.pixels = silhouette.count();
    fit.accuracyHull = hull.accuracy(points);
    fit.accuracySilhouette = fitAccuracy(PixelRegion(movedBy(points, hull.centre)), PixelRegion(silhouette));
    fit.reachedAccuracy = fit.accuracyHull >= settings.accuracy.value_or(fit.accuracyHull);
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
            fits.back().name = image.name(fits.size() - 1);
        }
        catch (const ValueError& error)
        {
            throw error.at(imagePath, image.name(fits.size()));
        }
    }
    return fits;
}

} // namespace chesil
