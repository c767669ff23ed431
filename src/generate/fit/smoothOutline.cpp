#include "generate/fit/smoothOutline.hpp"

#include "core/base/setupError.hpp"
#include "core/base/tolerances.hpp"
#include "generate/fit/outlineProblem.hpp"
#include "generate/image/convexHull.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace chesil
{

namespace
{

/// Least length of a handle, in units of the polygon's furthest vertex from its centroid: about half of the
/// pebbles' handles are as short. The few roundings of coordinates of that size, 1e-16 each, from here to the
/// grain about its own centroid then turn tangents by 1e-13 (standard deviation; at most 4e-13 of 4600
/// joints), and half as long handles by twice as much, too near to tolerances::joint for 10^4 grains.
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
            vertices.push_back(inUnits(vertex));
        }
    }

    Vector2 inUnits(const Vector2& point) const { return (point - centre) / radius; }

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

/// The ellipse with the second moments of a polygon: a smooth body as slender.
class InertiaEllipse
{
public:
    /// Of an ellipse, the covariance is a quarter of the squared half-axes.
    explicit InertiaEllipse(const std::vector<Vector2>& polygon) : squares_(4 * polygonCovariance(polygon)) {}

    /// Its support point.
    Vector2 point(const Vector2& normal) const
    {
        const Vector2 image = squares_ * normal;
        return image / std::sqrt(normal.dot(image));
    }

private:
    Eigen::Matrix2d squares_;
};

/// The smallest share of the ellipse that has to be mixed into the outline `sharp` for each tangent line to
/// hold its points with room to spare. Where a corner of the polygon is the support point of several
/// directions, the lines' pieces between their crossings vanish; those of the ellipse are long.
double ellipseShare(const JointFrame& frame, const Eigen::VectorXd& sharp, const Eigen::VectorXd& ellipse)
{
    // Of a piece, withHandles() gives an eighth at least to each gap.
    constexpr double wanted = 12 * leastHandle;
    double share = 0;
    const auto need = [&](double length, double wantedLength, double ofEllipse)
    {
        if (length < wantedLength && ofEllipse > length)
        {
            share = std::max(share, std::min(1.0, (wantedLength - length) / (ofEllipse - length)));
        }
    };
    for (int i = 0; i < frame.joints(); ++i)
    {
        const auto length = frame.edgeLengths(sharp, i);
        const auto ofEllipse = frame.edgeLengths(ellipse, i);
        if (frame.isCorner(i))
        {
            need(length[0], wanted / 2, ofEllipse[0]);
            need(length[1], wanted / 2, ofEllipse[1]);
        }
        else
        {
            need(length[0] + length[1], wanted, ofEllipse[0] + ofEllipse[1]);
        }
    }
    return share;
}

/// Joints at the polygon's support points, as far as corners allow; around them where even the ellipse has
/// too sharp a bend for so many of them.
Eigen::VectorXd startAtSupportPoints(const JointFrame& frame, const OutlineProblem& problem,
                                     const std::vector<Vector2>& supports, const InertiaEllipse& ellipse)
{
    const Eigen::VectorXd sharp = frame.atPoints(supports);
    Eigen::VectorXd start;
    for (const double rim : {0.0, 0.02, 0.1, 0.5})
    {
        std::vector<Vector2> ofEllipse;
        for (int i = 0; i < frame.joints(); ++i)
        {
            ofEllipse.push_back(ellipse.point(frame.normal(i)) + rim * frame.normal(i));
        }
        const Eigen::VectorXd round = frame.atPoints(ofEllipse);
        const double share = ellipseShare(frame, sharp, round);
        start = frame.withHandles((1 - share) * sharp + share * round);
        if (problem.allows(start))
        {
            break;
        }
    }
    return start;
}

/// A gap that is not used stays zero.
Eigen::ArrayXd leastGaps(const JointFrame& frame)
{
    const std::array<double, 4> least{leastMargin, leastHandle, leastHandle, leastMargin};
    Eigen::ArrayXd gaps(JointFrame::perJoint * frame.joints());
    for (int i = 0; i < frame.joints(); ++i)
    {
        for (int part = 0; part < JointFrame::perJoint; ++part)
        {
            gaps[JointFrame::perJoint * i + part] =
                frame.hasGap(i, part) ? least[static_cast<std::size_t>(part)] : -1;
        }
    }
    return gaps;
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

/// Where a corner's normals were given, a straight side beside it may have turned beyond them.
bool cornersTurnOutward(const std::vector<CubicBezier>& segments)
{
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
        const Vector2 before = segments[i].endTangent();
        const Vector2 after = segments[(i + 1) % segments.size()].startTangent();
        if (cross(before, after) < -tolerances::convexity * before.norm() * after.norm())
        {
            return false;
        }
    }
    return true;
}

std::optional<OutlineFit> solved(const std::vector<Vector2>& polygon, const JointPlan& plan)
{
    const UnitPolygon unit(polygon);
    const JointFrame frame(plan.joints());
    std::vector<Vector2> supports;
    std::vector<double> supportValues;
    for (int i = 0; i < frame.joints(); ++i)
    {
        const PlannedJoint& joint = plan.joints()[static_cast<std::size_t>(i)];
        supports.push_back(joint.isCorner() ? unit.inUnits(joint.corner) : unit.support(frame.normal(i)));
        supportValues.push_back(supports.back().dot(frame.normal(i)));
    }

    const EdgeLines lines(unit.vertices);
    const OutlineProblem problem(frame, lines, supportValues, leastGaps(frame));
    Eigen::VectorXd z = startAtSupportPoints(frame, problem, supports, InertiaEllipse(unit.vertices));
    if (!problem.allows(z))
    {
        return std::nullopt;
    }
    solve(problem, z);

    std::vector<CubicBezier> segments;
    for (int i = 0; i < frame.joints(); ++i)
    {
        segments.push_back(frame.segment(z, i).transformed(unit.centre, 1, 0, unit.radius));
    }
    return OutlineFit{std::move(segments), unit.radius * problem.distance(z), problem.segmentErrors(z)};
}

} // namespace

void requireFittable(const std::vector<Vector2>& polygon, int segments)
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

std::vector<CubicBezier> fitSmoothOutline(const std::vector<Vector2>& polygon, int segments)
{
    requireFittable(polygon, segments);
    return fitWithoutCorners(polygon, JointPlan::adapted(polygon, segments, 0)).segments;
}

std::optional<OutlineFit> fitAtJoints(const std::vector<Vector2>& polygon, const JointPlan& plan)
{
    std::optional<OutlineFit> fit = solved(polygon, plan);
    return fit && cornersTurnOutward(fit->segments) ? fit : std::nullopt;
}

OutlineFit fitWithoutCorners(const std::vector<Vector2>& polygon, JointPlan plan)
{
    for (const double share : {0.0, 0.05, 0.15, 0.4})
    {
        plan.even(share);
        if (const std::optional<OutlineFit> fit = fitAtJoints(polygon, plan))
        {
            return *fit;
        }
    }
    plan.even(1);
    return fitAtJoints(polygon, plan).value();
}

std::vector<Vector2> fitPolygon(const std::vector<Vector2>& polygon, int sides)
{
    requireFittable(polygon, sides);
    const OutlineFit fit = solved(polygon, JointPlan::polygon(polygon, sides)).value();
    std::vector<Vector2> vertices;
    for (const CubicBezier& side : fit.segments)
    {
        vertices.push_back(side.start());
    }
    return convexHull(vertices);
}

} // namespace chesil
