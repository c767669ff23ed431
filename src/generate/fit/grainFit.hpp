#pragma once

#include "core/shapes/shape.hpp"
#include "generate/fit/jointPlan.hpp"
#include "generate/fit/swarmFit.hpp"
#include "generate/image/silhouetteReader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace chesil
{

/// A grain fitted to a silhouette, and how well it fits.
struct GrainFit
{
    /// About its centroid, turned as in the image, x to the right, y up; unit: pixel times the scale given.
    Shape grain;
    /// ImageGrains::name.
    std::string name{};
    /// What an ellipse, whose half-axes are along x and y, has to be turned by counter-clockwise [rad] to be
    /// as in the image; 0 for the other shapes.
    double angle = 0;
    /// Bezier segments or sides; 1 of an ellipse.
    int segments = 0;
    /// The centroid in the image's frame (origin at its lower left corner, y up), in the same unit.
    Vector2 centroid = Vector2::Zero();
    int pixels = 0;
    /// 1 - (differing pixels) / (pixels of the silhouette, or of its convex hull): see PixelRegion.
    double accuracySilhouette = 0;
    double accuracyHull = 0;
    /// From silhouette to grain, measuring of the accuracy not included.
    double milliseconds = 0;
    /// False if an accuracy was wanted and the most segments allowed did not reach it.
    bool reachedAccuracy = true;
};

/// Where the joints of the direct solver stand: see JointPlan.
enum class JointSpacing
{
    equal,
    adapted
};

enum class FitMethod
{
    /// fitWithCorners: all offsets, joints and handles at once, by Gauss-Newton.
    direct,
    /// fitBySwarm: Lai & Huang's particle swarm.
    swarm
};

enum class GrainModel
{
    polyBezier,
    /// The better of fitPolygon and largestInscribed, enlarged to the hull's area.
    polygon,
    /// With the second moments of the convex outline.
    ellipse
};

struct FitSettings
{
    /// Of each grain, or sides of a polygon; see fewestSegments and mostSegments. With `accuracy`: the most
    /// allowed.
    int segments = 10;
    /// Size of a pixel, in the unit that the grains shall have.
    double scale = 1;
    GrainModel model = GrainModel::polyBezier;
    FitMethod method = FitMethod::direct;
    /// Of the direct method; the swarm's joints are equally spaced.
    JointSpacing joints = JointSpacing::adapted;
    SwarmSettings swarm;
    /// Wanted accuracy against the convex hull: segments are added until it is reached. Adapted joints are
    /// added where the error is, else the fit is repeated with one segment more. No matter for an ellipse.
    std::optional<double> accuracy;
};

/// Fits a grain to the finestHull of the silhouette. Throws ValueError as the method and the shape do.
GrainFit fitGrain(const Silhouette& silhouette, const FitSettings& settings = {});

/// All grains of an image, in its order. Throws SetupError that names `imagePath` and the setting that is out
/// of range or the grain that cannot be fitted.
std::vector<GrainFit> fitGrains(const std::string& imagePath, const ImageGrains& image,
                                const FitSettings& settings = {});

} // namespace chesil
