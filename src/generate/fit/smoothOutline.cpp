#include "generate/fit/smoothOutline.hpp"

#include "core/base/setupError.hpp"
#include "generate/fit/convexHull.hpp"
#include "generate/fit/outlineProblem.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace chesil
{

namespace
{

/// Least length of a handle, in units of the polygon's furthest vertex from its centroid: the rounding of
/// coordinates of that size, 1e-16, then turns a tangent by 1e-13.
constexpr double leastHandle = 2e-3;

/// Least gap between a handle's end and the crossing of the tangent lines, in the same unit: two such gaps
/// hold the shortest control edge Q1 Q2, whose direction may err by tolerances::convexity.
constexpr double leastMargin = 1e-5;

/// A polygon about its centroid, its furthest vertex at distance 1.
struct UnitPolygon
{
    explicit UnitPolygon(const std::vector<Vector2>& polygon) : centre(polygonCentroid(polygon))
    {
        for (const Vector2& vertex : polygon)
        {
            radius = std::max(radius, (vertex - centre).norm());
        }
        for (const Vector2& vertex : polygon)
        {
            vertices.push_back((vertex - centre) / radius);
        }
    }

    const Vector2& support(const Vector2& direction) const
    {
        return *std::max_element(vertices.begin(), vertices.end(),
                                 [&](const Vector2& a, const Vector2& b)
                                 { return direction.dot(a) < direction.dot(b); });
    }

    Vector2 centre;
    double radius = 0;
    std::vector<Vector2> vertices;
};

std::vector<double> equalAngles(int count)
{
    std::vector<double> angles;
    for (int i = 0; i < count; ++i)
    {
        angles.push_back(2 * M_PI * i / count);
    }
    return angles;
}

/// The smallest share of the unit circle that has to be mixed into the outline `sharp` for each tangent
/// line to hold its points with room to spare. Where a corner of the polygon is the support point of
/// several directions, the lines' pieces between their crossings vanish; those of the circle are long.
double circleShare(const JointFrame& frame, const Eigen::VectorXd& sharp, const Eigen::VectorXd& circle)
{
    // Of a piece, start() gives an eighth at least to each gap.
    constexpr double wanted = 12 * leastHandle;
    double share = 0;
    for (int i = 0; i < frame.joints(); ++i)
    {
        const double length = frame.edgeLength(sharp, i);
        if (length < wanted)
        {
            share = std::max(share, (wanted - length) / (frame.edgeLength(circle, i) - length));
        }
    }
    return share;
}

/// Joints at the polygon's support points, as far as corners allow.
Eigen::VectorXd startAtSupportPoints(const JointFrame& frame, const std::vector<Vector2>& supports,
                                     const std::vector<double>& supportValues)
{
    const std::vector<double> ones(supportValues.size(), 1.0);
    const double share = circleShare(frame, frame.tangentLines(supportValues), frame.tangentLines(ones));
    std::vector<double> offsets;
    for (const double value : supportValues)
    {
        offsets.push_back((1 - share) * value + share);
    }
    return frame.start(offsets, supports);
}

Eigen::ArrayXd leastGaps(int joints)
{
    return Eigen::Array4d(leastMargin, leastHandle, leastHandle, leastMargin).replicate(joints, 1);
}

/// Newton steps down the barrier until it no longer shows.
void solve(const OutlineProblem& problem, Eigen::VectorXd& z)
{
    constexpr int iterations = 24;
    constexpr double firstBarrier = 1e-4;
    constexpr double lastBarrier = 1e-11;
    double barrier = firstBarrier;
    for (int iteration = 0; iteration < iterations; ++iteration)
    {
        const std::vector<double> weights = problem.sampleWeights(z);
        const double before = problem.value(z, weights, barrier);
        const Eigen::VectorXd step = problem.step(z, weights, barrier);
        double share = problem.longestShare(z, step);
        for (int halving = 0; halving < 8; ++halving, share /= 2)
        {
            const Eigen::VectorXd trial = z + share * step;
            if (problem.value(trial, weights, barrier) < before)
            {
                z = trial;
                break;
            }
        }
        barrier = std::max(lastBarrier, 0.3 * barrier);
    }
}

void check(const std::vector<Vector2>& polygon, int segments)
{
    if (segments < fewestSegments || segments > mostSegments)
    {
        throw ValueError(std::to_string(segments) + " segments",
                         std::to_string(fewestSegments) + " to " + std::to_string(mostSegments));
    }
    if (polygon.size() < 3 || !(polygonArea(polygon) > 0))
    {
        throw ValueError("an outline without area", "a convex outline, counter-clockwise");
    }
}

} // namespace

std::vector<CubicBezier> fitSmoothOutline(const std::vector<Vector2>& polygon, int segments)
{
    check(polygon, segments);
    const UnitPolygon unit(polygon);
    const JointFrame frame(equalAngles(segments));
    std::vector<Vector2> supports;
    std::vector<double> supportValues;
    for (int i = 0; i < frame.joints(); ++i)
    {
        supports.push_back(unit.support(frame.normal(i)));
        supportValues.push_back(supports.back().dot(frame.normal(i)));
    }

    Eigen::VectorXd z = startAtSupportPoints(frame, supports, supportValues);
    const EdgeLines lines(unit.vertices);
    solve(OutlineProblem(frame, lines, supportValues, leastGaps(segments)), z);

    std::vector<CubicBezier> outline;
    for (int i = 0; i < frame.joints(); ++i)
    {
        outline.push_back(frame.segment(z, i).transformed(unit.centre, 1, 0, unit.radius));
    }
    return outline;
}

} // namespace chesil
