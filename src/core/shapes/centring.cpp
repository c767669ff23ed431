#include "core/shapes/centring.hpp"

#include "core/base/tolerances.hpp"

#include <cmath>

namespace chesil
{

namespace
{

std::vector<CubicBezier> shifted(const std::vector<CubicBezier>& segments, const Vector2& by)
{
    std::vector<CubicBezier> result;
    result.reserve(segments.size());
    for (const CubicBezier& segment : segments)
    {
        result.push_back(segment.transformed(by, 1, 0, 1));
    }
    return result;
}

} // namespace

CentredBoundary centred(const std::vector<CubicBezier>& segments)
{
    // About the first joint, since the frame's origin may lie many sizes away.
    const Vector2 reference = segments.front().start();
    const std::vector<CubicBezier> near = shifted(segments, -reference);
    const AreaMoments nearMoments = regionMoments(near);
    const Vector2 fromReference = nearMoments.centroid();

    CentredBoundary result;
    result.givenCentroid = reference + fromReference;
    const double size = std::sqrt(nearMoments.area);
    const bool there = result.givenCentroid.norm() <= tolerances::centroid * size;
    result.segments = there ? segments : shifted(near, -fromReference);
    const AreaMoments moments = regionMoments(result.segments);
    result.mass = {moments.area, moments.polarAboutCentroid()};
    return result;
}

} // namespace chesil
