#include "generate/descriptors/fourierSpectrum.hpp"

#include "generate/image/convexHull.hpp"

#include <cmath>
#include <complex>

namespace chesil
{

namespace
{

constexpr std::size_t rays = 128;

/// Distances of the outline from `centre`, ray by ray; empty if it is not star-shaped about it.
std::vector<double> radii(const ClosedOutline& outline, const Vector2& centre, const Vector2& firstRay)
{
    std::vector<double> found(rays, 0);
    const double first = std::atan2(firstRay.y(), firstRay.x());
    constexpr double spacing = 2 * M_PI / rays;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Vector2 start = outline[i] - centre;
        const Vector2 end = outline[(i + 1) % outline.size()] - centre;
        if (!(cross(start, end) > 0))
        {
            return {};
        }
        // The rays from the start's angle on, up to the end's.
        const double from = (std::atan2(start.y(), start.x()) - first) / spacing;
        const double to = from + std::atan2(cross(start, end), start.dot(end)) / spacing;
        // A ray through a vertex may be found twice, but not missed by rounding.
        for (double ray = std::ceil(from - 1e-9); ray < to + 1e-9; ++ray)
        {
            const double angle = first + ray * spacing;
            const Vector2 direction(std::cos(angle), std::sin(angle));
            const auto index = static_cast<std::size_t>(ray + 4 * rays) % rays;
            found[index] = cross(start, end - start) / cross(direction, end - start);
        }
    }
    return found;
}

} // namespace

std::optional<std::vector<double>> fourierSpectrum(const ClosedOutline& outline, const Vector2& firstRay)
{
    const std::vector<double> distances = radii(outline, polygonCentroid(outline), firstRay);
    if (distances.empty())
    {
        return std::nullopt;
    }
    std::vector<double> amplitudes;
    for (std::size_t n = 0; n <= rays / 2; ++n)
    {
        std::complex<double> sum = 0;
        for (std::size_t i = 0; i < rays; ++i)
        {
            sum += std::polar(distances[i], 2 * M_PI * static_cast<double>(n * i % rays) / rays);
        }
        amplitudes.push_back(std::abs(sum) * (n == 0 || 2 * n == rays ? 1 : 2) / rays);
    }
    const double mean = amplitudes.front();
    for (double& amplitude : amplitudes)
    {
        amplitude /= mean;
    }
    return amplitudes;
}

} // namespace chesil
