#include "generate/image/convexHull.hpp"

#include "core/geometry/areaMoments.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <cmath>
#include <iterator>
#include <numeric>

namespace chesil
{

namespace
{

AreaMoments polygonMoments(const std::vector<Vector2>& vertices)
{
    AreaMoments moments;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        moments += boundaryMoments(CubicBezier::straight(vertices[i], vertices[(i + 1) % vertices.size()]));
    }
    return moments;
}

/// Centres of the first and last dark pixel of each row: all that the hull needs.
std::vector<Vector2> rowEndCentres(const Silhouette& silhouette)
{
    std::vector<Vector2> centres;
    for (int y = 0; y < silhouette.height(); ++y)
    {
        int first = 0;
        int last = silhouette.width() - 1;
        while (first <= last && !silhouette.dark(first, y))
        {
            ++first;
        }
        while (last >= first && !silhouette.dark(last, y))
        {
            --last;
        }
        if (first <= last)
        {
            centres.emplace_back(first + 0.5, y + 0.5);
            centres.emplace_back(last + 0.5, y + 0.5);
        }
    }
    return centres;
}

std::vector<Vector2> boxAround(const std::vector<Vector2>& centres)
{
    Vector2 low = centres.front();
    Vector2 high = low;
    for (const Vector2& centre : centres)
    {
        low = low.cwiseMin(centre);
        high = high.cwiseMax(centre);
    }
    low -= Vector2(0.5, 0.5);
    high += Vector2(0.5, 0.5);
    return {low, Vector2(high.x(), low.y()), high, Vector2(low.x(), high.y())};
}

/// The part of a convex polygon where normal . x <= offset.
std::vector<Vector2> clipped(const std::vector<Vector2>& polygon, const Vector2& normal, double offset)
{
    std::vector<Vector2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const Vector2& a = polygon[i];
        const Vector2& b = polygon[(i + 1) % polygon.size()];
        const double beyondA = normal.dot(a) - offset;
        const double beyondB = normal.dot(b) - offset;
        if (beyondA <= 0)
        {
            kept.push_back(a);
        }
        if ((beyondA < 0 && beyondB > 0) || (beyondA > 0 && beyondB < 0))
        {
            kept.push_back(a + beyondA / (beyondA - beyondB) * (b - a));
        }
    }
    return kept;
}

/// Without vertices that rounding alone tells from the one before.
std::vector<Vector2> withoutTinyEdges(const std::vector<Vector2>& polygon)
{
    constexpr double tiny = 1e-6;
    std::vector<Vector2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        if ((polygon[(i + 1) % polygon.size()] - polygon[i]).norm() > tiny)
        {
            kept.push_back(polygon[i]);
        }
    }
    return kept;
}

/// Without vertices that stand out of the chord between their neighbours by less than `tolerance`, counted from the last
/// one kept; no larger than it was.
std::vector<Vector2> simplified(const std::vector<Vector2>& polygon, double tolerance)
{
    std::vector<Vector2> kept{polygon.front()};
    std::size_t last = 0;
    for (std::size_t i = 1; i < polygon.size(); ++i)
    {
        const Vector2 chord = polygon[(i + 1) % polygon.size()] - polygon[last];
        const auto standsOut = [&](std::size_t k)
        { return cross(polygon[k] - polygon[last], chord) > tolerance * chord.norm(); };
        bool needed = false;
        for (std::size_t k = last + 1; k <= i && !needed; ++k)
        {
            needed = standsOut(k);
        }
        if (needed)
        {
            kept.push_back(polygon[i]);
            last = i;
        }
    }
    return kept;
}

} // namespace

std::vector<Vector2> convexOutline(const Silhouette& silhouette)
{
    const std::vector<Vector2> centres = rowEndCentres(silhouette);
    const std::vector<Vector2> hull = convexHull(centres);
    std::vector<Vector2> outline = boxAround(centres);
    for (std::size_t i = 0; i < hull.size() && hull.size() > 1; ++i)
    {
        const Vector2 edge = hull[(i + 1) % hull.size()] - hull[i];
        const int steps = std::gcd(static_cast<int>(edge.x()), static_cast<int>(edge.y()));
        const Vector2 normal = -perpendicular(edge).normalized();
        outline = clipped(outline, normal, normal.dot(hull[i]) + 0.5 * steps / edge.norm());
    }
    return withoutTinyEdges(outline);
}

std::vector<Vector2> finestHull(const Silhouette& silhouette)
{
    // A fifth of what a contour of grey values errs by (tests/unit/generate/image/testSubPixelOutline.cpp).
    constexpr double tolerance = 0.02;
    return silhouette.outline().empty() ? convexOutline(silhouette) : simplified(convexHull(silhouette.outline()), tolerance);
}

std::vector<Vector2> convexHull(const std::vector<Vector2>& points)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_2> given;
    given.reserve(points.size());
    for (const Vector2& point : points)
    {
        given.emplace_back(point.x(), point.y());
    }
    std::vector<Kernel::Point_2> found;
    CGAL::convex_hull_2(given.begin(), given.end(), std::back_inserter(found));

    std::vector<Vector2> hull;
    hull.reserve(found.size());
    for (const Kernel::Point_2& point : found)
    {
        hull.emplace_back(point.x(), point.y());
    }
    return hull;
}

double polygonArea(const std::vector<Vector2>& vertices) { return polygonMoments(vertices).area; }

Vector2 polygonCentroid(const std::vector<Vector2>& vertices) { return polygonMoments(vertices).centroid(); }

Eigen::Matrix2d polygonCovariance(const std::vector<Vector2>& vertices)
{
    const Vector2 centroid = polygonCentroid(vertices);
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        // Of the triangle between the centroid, a and b: twice its area / 24 times these squares
        const Vector2 a = vertices[i] - centroid;
        const Vector2 b = vertices[(i + 1) % vertices.size()] - centroid;
        sum += cross(a, b) / 24 * (a * a.transpose() + b * b.transpose() + (a + b) * (a + b).transpose());
    }
    return sum / polygonArea(vertices);
}

} // namespace chesil
