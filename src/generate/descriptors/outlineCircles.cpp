#include "generate/descriptors/outlineCircles.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Min_circle_2.h>
#include <CGAL/Min_circle_2_traits_2.h>
#include <CGAL/Min_sphere_of_points_d_traits_2.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace chesil
{

namespace
{

Vector2 nearestOn(const Vector2& start, const Vector2& end, const Vector2& point)
{
    const Vector2 edge = end - start;
    const double share = std::clamp((point - start).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    return start + share * edge;
}

/// Distance from the edge, negative outside.
double depthIn(const ClosedOutline& outline, const Vector2& point)
{
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Vector2& a = outline[i];
        const Vector2& b = outline[(i + 1) % outline.size()];
        nearest = std::min(nearest, (nearestOn(a, b, point) - point).squaredNorm());
        if ((a.y() > point.y()) != (b.y() > point.y())
            && point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        {
            inside = !inside;
        }
    }
    return (inside ? 1 : -1) * std::sqrt(nearest);
}

struct Square
{
    Vector2 centre;
    double half;
    double depth;

    double most() const { return depth + M_SQRT2 * half; }
    bool operator<(const Square& other) const { return most() < other.most(); }
};

OutlineCircle coarseInscribed(const ClosedOutline& outline)
{
    constexpr double precision = 1e-4;
    Vector2 low = outline.front();
    Vector2 high = outline.front();
    for (const Vector2& point : outline)
    {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    const Vector2 middle = (low + high) / 2;
    std::priority_queue<Square> squares;
    squares.push({middle, (high - low).maxCoeff() / 2, depthIn(outline, middle)});
    OutlineCircle best{middle, squares.top().depth};
    while (!squares.empty() && squares.top().most() > best.radius * (1 + precision))
    {
        const Square whole = squares.top();
        squares.pop();
        for (const Vector2& side : {Vector2(-1, -1), Vector2(1, -1), Vector2(-1, 1), Vector2(1, 1)})
        {
            const Vector2 centre = whole.centre + whole.half / 2 * side;
            const Square quarter{centre, whole.half / 2, depthIn(outline, centre)};
            if (quarter.depth > best.radius)
            {
                best = {centre, quarter.depth};
            }
            squares.push(quarter);
        }
    }
    return best;
}

/// radius <= distance - toEdge . move.
struct Bound
{
    Vector2 toEdge;
    double distance;
};

/// The nearest point of the edge in each of some directions around a point inside.
std::vector<Bound> boundsAround(const ClosedOutline& outline, const Vector2& point)
{
    constexpr std::size_t sectors = 24;
    constexpr double none = std::numeric_limits<double>::infinity();
    std::array<Bound, sectors> nearest;
    nearest.fill({Vector2::Zero(), none});
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Vector2 way = nearestOn(outline[i], outline[(i + 1) % outline.size()], point) - point;
        const double turn = std::atan2(way.y(), way.x()) / (2 * M_PI) + 0.5;
        const std::size_t sector = std::min(static_cast<std::size_t>(turn * sectors), sectors - 1);
        const double distance = way.norm();
        if (distance < nearest[sector].distance)
        {
            nearest[sector] = {way / distance, distance};
        }
    }
    std::vector<Bound> bounds;
    std::copy_if(
        nearest.begin(), nearest.end(), std::back_inserter(bounds), [](const Bound& bound) { return bound.distance < none; });
    return bounds;
}

/// The move, by at most `trust` in x and y, after which the least of the bounds is largest: the best corner of the linear
/// programme in the move and the gain over `radius`.
Vector2 bestMove(const std::vector<Bound>& bounds, double radius, double trust)
{
    struct Row
    {
        Eigen::Vector3d slope;
        double most;
    };
    std::vector<Row> rows;
    for (const Bound& bound : bounds)
    {
        // Others are out of reach.
        if (bound.distance - radius < 4 * trust)
        {
            rows.push_back({{bound.toEdge.x(), bound.toEdge.y(), 1}, bound.distance - radius});
        }
    }
    for (const double sign : {-1.0, 1.0})
    {
        rows.push_back({{sign, 0, 0}, trust});
        rows.push_back({{0, sign, 0}, trust});
    }
    Eigen::Vector3d best(0, 0, -std::numeric_limits<double>::infinity());
    const double rounding = 1e-13 * trust + std::numeric_limits<double>::epsilon() * radius;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            for (std::size_t k = 0; k < j; ++k)
            {
                Eigen::Matrix3d matrix;
                matrix << rows[i].slope.transpose(), rows[j].slope.transpose(), rows[k].slope.transpose();
                if (std::abs(matrix.determinant()) < 1e-12)
                {
                    continue;
                }
                const Eigen::Vector3d corner = matrix.inverse() * Eigen::Vector3d(rows[i].most, rows[j].most, rows[k].most);
                const bool allowed = std::all_of(
                    rows.begin(), rows.end(), [&](const Row& row) { return row.slope.dot(corner) <= row.most + rounding; });
                if (allowed && corner.z() > best.z())
                {
                    best = corner;
                }
            }
        }
    }
    return std::isfinite(best.z()) ? Vector2(best.head<2>()) : Vector2(Vector2::Zero());
}

} // namespace

OutlineCircle circumscribedCircle(const ClosedOutline& points)
{
    // Good to 1e-9 only: it tells the few points that the circle may rest on.
    using Traits = CGAL::Min_sphere_of_points_d_traits_2<CGAL::Simple_cartesian<double>, double>;
    std::vector<CGAL::Simple_cartesian<double>::Point_2> all;
    all.reserve(points.size());
    for (const Vector2& point : points)
    {
        all.emplace_back(point.x() - points[0].x(), point.y() - points[0].y());
    }
    CGAL::Min_sphere_of_spheres_d<Traits> sphere(all.begin(), all.end());
    const auto* found = sphere.center_cartesian_begin();
    const Vector2 near(found[0], found[1]);
    const double least = sphere.radius() * (1 - 1e-7);

    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    std::vector<Exact::Point_2> outermost;
    for (const Vector2& point : points)
    {
        const Vector2 relative = point - points[0];
        if ((relative - near).norm() > least)
        {
            outermost.emplace_back(relative.x(), relative.y());
        }
    }
    const CGAL::Min_circle_2<CGAL::Min_circle_2_traits_2<Exact>> circle(outermost.begin(), outermost.end(), true);
    const Vector2 centre(CGAL::to_double(circle.circle().center().x()), CGAL::to_double(circle.circle().center().y()));
    return {points[0] + centre, std::sqrt(CGAL::to_double(circle.circle().squared_radius()))};
}

OutlineCircle inscribedCircle(const ClosedOutline& outline)
{
    // Smooth curves come in ten thousand sides: a place to start is found with fewer.
    constexpr std::size_t enough = 1000;
    ClosedOutline coarse;
    for (std::size_t i = 0; i < outline.size(); i += 1 + outline.size() / enough)
    {
        coarse.push_back(outline[i]);
    }
    OutlineCircle circle = coarseInscribed(coarse);
    circle.radius = depthIn(outline, circle.centre);
    double trust = 1e-2 * circle.radius;
    // What the place that was tried last told, seen from here: it says where the edge turns.
    std::vector<Bound> told;
    while (trust > 1e-15 * circle.radius)
    {
        std::vector<Bound> bounds = boundsAround(outline, circle.centre);
        bounds.insert(bounds.end(), told.begin(), told.end());
        const Vector2 move = bestMove(bounds, circle.radius, trust);
        const Vector2 tried = circle.centre + move;
        const double depth = depthIn(outline, tried);
        const double gain = depth - circle.radius;
        told = boundsAround(outline, tried);
        if (gain > 0)
        {
            circle = {tried, depth};
            told.clear();
        }
        for (Bound& bound : told)
        {
            bound.distance += bound.toEdge.dot(move);
        }
        if (gain < 1e-3 * trust)
        {
            trust /= 2;
        }
    }
    return circle;
}

} // namespace chesil
