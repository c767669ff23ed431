#include "generate/fit/smoothOutline.hpp"

#include "core/base/setupError.hpp"
#include "generate/fit/convexHull.hpp"
#include "generate/fit/jointFrame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace chesil
{

namespace
{

/// Least gap between neighbouring points of a tangent line, in radii of the grain.
constexpr double leastGap = 2e-3;

/// The lines through a convex polygon's edges, normals outward. The distance of a point is taken to the
/// line that it is furthest out of: exact inside and beside the edges; outside a vertex too small by a
/// factor of the cosine of half the turn there at most.
class EdgeLines
{
public:
    struct Distance
    {
        double value;
        Vector2 normal;
    };

    explicit EdgeLines(const std::vector<Vector2>& polygon)
        : normals_(polygon.size(), 2), offsets_(polygon.size())
    {
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
            const Vector2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
            const Vector2 normal = -perpendicular(edge).normalized();
            const auto row = static_cast<Eigen::Index>(i);
            normals_.row(row) = normal.transpose();
            offsets_[row] = normal.dot(polygon[i]);
        }
    }

    /// Signed, positive outside.
    Distance distance(const Vector2& point) const
    {
        Eigen::Index furthest = 0;
        const double value = (normals_ * point - offsets_).maxCoeff(&furthest);
        return {value, normals_.row(furthest).transpose()};
    }

private:
    Eigen::Matrix<double, Eigen::Dynamic, 2> normals_;
    Eigen::VectorXd offsets_;
};

/// Mean squared distance of an outline's points from the polygon, and its logarithmic barrier.
class OutlineProblem
{
public:
    OutlineProblem(const JointFrame& frame, const EdgeLines& lines) : frame_(frame), lines_(lines) {}

    /// Share of the perimeter that each sample stands for.
    std::vector<double> sampleWeights(const Eigen::VectorXd& z) const
    {
        std::vector<double> weights;
        double total = 0;
        for (int i = 0; i < frame_.joints(); ++i)
        {
            const CubicBezier segment = frame_.segment(z, i);
            for (int k = 0; k < samples; ++k)
            {
                weights.push_back(segment.derivative(parameter(k)).norm());
                total += weights.back();
            }
        }
        for (double& weight : weights)
        {
            weight /= total;
        }
        return weights;
    }

    double value(const Eigen::VectorXd& z, const std::vector<double>& weights, double barrier) const
    {
        const Eigen::ArrayXd gaps = spareGaps(z);
        if (!(gaps.minCoeff() > 0))
        {
            return std::numeric_limits<double>::infinity();
        }
        double sum = 0;
        std::size_t sample = 0;
        for (int i = 0; i < frame_.joints(); ++i)
        {
            const CubicBezier segment = frame_.segment(z, i);
            for (int k = 0; k < samples; ++k, ++sample)
            {
                const double distance = lines_.distance(segment.at(parameter(k))).value;
                sum += weights[sample] * distance * distance;
            }
        }
        return sum / 2 - barrier * gaps.log().sum();
    }

    /// The Gauss-Newton step: each sample keeps its edge line and weight.
    Eigen::VectorXd step(const Eigen::VectorXd& z, const std::vector<double>& weights, double barrier) const
    {
        const Eigen::ArrayXd inverseGaps = spareGaps(z).inverse();
        const Eigen::MatrixXd& gapMatrix = frame_.gapMatrix();
        Eigen::MatrixXd hessian =
            gapMatrix.transpose() * (barrier * inverseGaps.square()).matrix().asDiagonal() * gapMatrix;
        Eigen::VectorXd gradient = -barrier * gapMatrix.transpose() * inverseGaps.matrix();
        addSquares(z, weights, hessian, gradient);
        return hessian.ldlt().solve(-gradient);
    }

    /// The longest share of a step, at most 1, that uses up no more than 90 % of any gap.
    double longestShare(const Eigen::VectorXd& z, const Eigen::VectorXd& step) const
    {
        const double use = -((frame_.gapMatrix() * step).array() / spareGaps(z)).minCoeff();
        return use > 0.9 ? 0.9 / use : 1;
    }

private:
    static constexpr int samples = 24;

    static double parameter(int k) { return (k + 0.5) / samples; }

    Eigen::ArrayXd spareGaps(const Eigen::VectorXd& z) const
    {
        return (frame_.gapMatrix() * z).array() - leastGap;
    }

    void addSquares(const Eigen::VectorXd& z, const std::vector<double>& weights, Eigen::MatrixXd& hessian,
                    Eigen::VectorXd& gradient) const
    {
        constexpr int per = JointFrame::perJoint;
        std::size_t sample = 0;
        for (int i = 0; i < frame_.joints(); ++i)
        {
            const CubicBezier segment = frame_.segment(z, i);
            Eigen::Matrix<double, 2 * per, 2 * per> block = Eigen::Matrix<double, 2 * per, 2 * per>::Zero();
            Eigen::Matrix<double, 2 * per, 1> slope = Eigen::Matrix<double, 2 * per, 1>::Zero();
            for (int k = 0; k < samples; ++k, ++sample)
            {
                const EdgeLines::Distance distance = lines_.distance(segment.at(parameter(k)));
                const auto entries = frame_.pointGradient(i, parameter(k), distance.normal);
                const Eigen::Map<const Eigen::Matrix<double, 2 * per, 1>> row(entries.data());
                block += weights[sample] * row * row.transpose();
                slope += weights[sample] * distance.value * row;
            }
            const std::array<int, 2> places{per * i, per * frame_.next(i)};
            for (int a = 0; a < 2; ++a)
            {
                gradient.segment<per>(places[a]) += slope.segment<per>(per * a);
                for (int b = 0; b < 2; ++b)
                {
                    hessian.block<per, per>(places[a], places[b]) += block.block<per, per>(per * a, per * b);
                }
            }
        }
    }

    const JointFrame& frame_;
    const EdgeLines& lines_;
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

Vector2 supportOf(const std::vector<Vector2>& polygon, const Vector2& direction)
{
    return *std::max_element(polygon.begin(), polygon.end(),
                             [&](const Vector2& a, const Vector2& b)
                             { return direction.dot(a) < direction.dot(b); });
}

/// Joints at the polygon's support points. Where a corner serves several directions, edges of the tangents'
/// polygon vanish; mixing in as much of the unit circle as needed, whose edges are all of one length,
/// gives each at least a tenth of that length.
Eigen::VectorXd startAtSupportPoints(const JointFrame& frame, const std::vector<Vector2>& polygon)
{
    std::vector<double> offsets;
    std::vector<Vector2> supports;
    for (int i = 0; i < frame.joints(); ++i)
    {
        supports.push_back(supportOf(polygon, frame.normal(i)));
        offsets.push_back(supports.back().dot(frame.normal(i)));
    }
    const Eigen::VectorXd sharp = frame.start(offsets, supports);
    const std::vector<double> circleOffsets(offsets.size(), 1.0);
    const Eigen::VectorXd circle = frame.start(circleOffsets, supports);
    double share = 0;
    for (int i = 0; i < frame.joints(); ++i)
    {
        const double length = frame.edgeLength(sharp, i);
        const double circleLength = frame.edgeLength(circle, i);
        const double wanted = 0.1 * circleLength;
        if (length < wanted)
        {
            share = std::max(share, (wanted - length) / (circleLength - length));
        }
    }
    for (double& offset : offsets)
    {
        offset = (1 - share) * offset + share;
    }
    return frame.start(offsets, supports);
}

/// Goes down the barrier until it no longer shows.
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

} // namespace

std::vector<CubicBezier> fitSmoothOutline(const std::vector<Vector2>& polygon, int segments)
{
    if (segments < fewestSegments || segments > mostSegments)
    {
        throw ValueError(std::to_string(segments) + " segments",
                         std::to_string(fewestSegments) + " to " + std::to_string(mostSegments));
    }
    const double area = polygon.size() < 3 ? 0 : polygonArea(polygon);
    if (!(area > 0))
    {
        throw ValueError("an outline without area", "a convex outline, counter-clockwise");
    }

    const Vector2 centre = polygonCentroid(polygon);
    const double radius = std::sqrt(area / M_PI);
    std::vector<Vector2> scaled;
    for (const Vector2& vertex : polygon)
    {
        scaled.push_back((vertex - centre) / radius);
    }
    const JointFrame frame(equalAngles(segments));
    const EdgeLines lines(scaled);
    Eigen::VectorXd z = startAtSupportPoints(frame, scaled);
    solve(OutlineProblem(frame, lines), z);

    std::vector<CubicBezier> outline;
    for (int i = 0; i < frame.joints(); ++i)
    {
        outline.push_back(frame.segment(z, i).transformed(centre, 1, 0, radius));
    }
    return outline;
}

} // namespace chesil
