#pragma once

#include "core/shapes/polyBezier.hpp"
#include "generate/fit/swarmFit.hpp"
#include "generate/image/silhouetteReader.hpp"

#include <string>
#include <vector>

namespace chesil
{

/// A polybezier grain fitted to a silhouette, and how well it fits.
struct GrainFit
{
    /// About its centroid, turned as in the image, x to the right, y up; unit: pixel times the scale given.
    PolyBezier grain;
    /// The centroid in the image's frame (origin at its lower left corner, y up), in the same unit.
    Vector2 centroid = Vector2::Zero();
    int pixels = 0;
    /// 1 - (differing pixels) / (pixels of the silhouette, or of its convex hull): see PixelRegion.
    double accuracySilhouette = 0;
    double accuracyHull = 0;
    /// From silhouette to grain, measuring of the accuracy not included.
    double milliseconds = 0;
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

struct FitSettings
{
    /// Of each grain; see fewestSegments and mostSegments.
    int segments = 10;
    /// Size of a pixel, in the unit that the grains shall have.
    double scale = 1;
    FitMethod method = FitMethod::direct;
    /// Of the direct method; the swarm's joints are equally spaced.
    JointSpacing joints = JointSpacing::adapted;
    SwarmSettings swarm;
};

/// convexOutline of the silhouette, then fitSmoothOutline. Throws ValueError as the latter and PolyBezier do.
GrainFit fitGrain(const Silhouette& silhouette, const FitSettings& settings = {});

/// All grains of an image, in its order. Throws SetupError that names `imagePath` and the setting that is out
/// of range or the grain that cannot be fitted.
std::vector<GrainFit> fitGrains(const std::string& imagePath, const ImageGrains& image,
                                const FitSettings& settings = {});

/// The name of grain `index` (from 0) in template files, tables and messages: "grain1", "grain2", ...
std::string grainName(std::size_t index);

} // namespace chesil
