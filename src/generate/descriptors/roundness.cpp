#include "generate/descriptors/roundness.hpp"

#include "generate/descriptors/outlineCircles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

constexpr std::size_t coverPoints = 1000;

/// What lies within this share of the inscribed radius from a circle is covered by it.
constexpr double coverShare = 0.02;

/// Points may lie inside a circle by this share of the inscribed radius: more than what is left of a smoothed outline's noise.
constexpr double slackShare = 0.005;

/// Of an outline with this curvature times the inscribed radius: a ramp around 1, so that noise there has no net effect.
double cornerWeight(double curvature)
{
    constexpr double halfWidth = 0.2;
    return std::clamp((curvature - 1) / (2 * halfWidth) + 0.5, 0.0, 1.0);
}

/// The largest circle that touches each point of the outline from inside: through it, with its centre on its inward normal,
/// and with no other point deeper inside than `slack`.
std::vector<OutlineCircle> touchingCircles(const ClosedOutline& points, double slack)
{
    const std::size_t size = points.size();
    std::vector<OutlineCircle> circles;
    circles.reserve(size);
    for (std::size_t i = 0; i < size; ++i)
    {
        const Vector2& point = points[i];
        const Vector2 inward = perpendicular(unit(points[(i + 1) % size] - points[(i + size - 1) % size]));
        double radius = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < size; ++j)
        {
            const Vector2 way = points[j] - point;
            const double height = way.dot(inward);
            if (height > slack)
            {
                radius = std::min(radius, (way.squaredNorm() - slack * slack) / (2 * (height - slack)));
            }
        }
        circles.push_back({point + radius * inward, radius});
    }
    return circles;
}

/// Steps of the outline, in one piece with the point where it touches, that a circle covers.
double coveredSteps(const ClosedOutline& points, std::size_t touched, const OutlineCircle& circle, double near)
{
    const auto off = [&](std::size_t point) { return std::abs((points[point] - circle.centre).norm() - circle.radius); };
    const std::size_t size = points.size();
    double steps = 0;
    for (const std::size_t step : {std::size_t{1}, size - 1})
    {
        double last = 0;
        std::size_t point = touched;
        for (std::size_t passed = 0; passed < size / 2; ++passed)
        {
            point = (point + step) % size;
            const double now = off(point);
            if (now > near)
            {
                steps += (near - last) / (now - last);
                break;
            }
            last = now;
            ++steps;
        }
    }
    return steps;
}

} // namespace

double cornerRoundness(const ClosedOutline& outline, double inscribedRadius, double straight)
{
    const std::size_t size = outline.size();
    double length = 0;
    double angle = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
        const Vector2 before = outline[i] - outline[(i + size - 1) % size];
        const Vector2 after = outline[(i + 1) % size] - outline[i];
        const double turn = std::atan2(cross(before, after), before.dot(after));
        const double reach = (std::min(before.norm(), straight) + std::min(after.norm(), straight)) / 2;
        const double weight = cornerWeight(turn * inscribedRadius / reach);
        length += weight * reach;
        angle += weight * turn;
    }
    return angle > 0 ? length / angle / inscribedRadius : 1;
}

double coverRoundness(const ClosedOutline& outline, double inscribedRadius)
{
    const ClosedOutline points = resampled(outline, coverPoints);
    const std::vector<OutlineCircle> circles = touchingCircles(points, slackShare * inscribedRadius);
    double radii = 0;
    double number = 0;
    for (std::size_t i = 0; i < coverPoints; ++i)
    {
        const double share = 1 / coveredSteps(points, i, circles[i], coverShare * inscribedRadius);
        radii += share * std::min(circles[i].radius, inscribedRadius);
        number += share;
    }
    return radii / number / inscribedRadius;
}

} // namespace chesil
