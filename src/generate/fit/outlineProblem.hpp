#pragma once

#include "generate/fit/edgeLines.hpp"
#include "generate/fit/jointFrame.hpp"

#include <vector>

namespace chesil
{

/// What fitting an outline to a convex polygon minimises, as a function of the numbers z of a JointFrame:
///
///     1/2 mean of d^2 along the outline  +  1/2 supportWeight * mean of (offset_i - h_i)^2
///     - barrier * sum of log(gap - least gap)
///
/// with d the distance from the polygon and h_i the polygon's support value along the joint's normal. The
/// second term keeps the outline as long and as wide as the polygon: a short outline that clings to one side
/// of it would have a small d, too.
class OutlineProblem
{
public:
    /// `supportValues`: h_i. `leastGaps`: one for each gap of the frame, in the unit of z.
    OutlineProblem(const JointFrame& frame, const EdgeLines& lines, std::vector<double> supportValues,
                   Eigen::ArrayXd leastGaps);

    /// Share of the perimeter that each sample of the outline stands for, in the outline's order.
    std::vector<double> sampleWeights(const Eigen::VectorXd& z) const;

    /// All gaps are above their least ones.
    bool allows(const Eigen::VectorXd& z) const { return spareGaps(z).minCoeff() > 0; }

    /// Root of the mean squared distance of the outline from the polygon.
    double distance(const Eigen::VectorXd& z) const;

    /// Integral of the distance's size along each segment.
    std::vector<double> segmentErrors(const Eigen::VectorXd& z) const;

    /// Infinite if a gap is not above its least one.
    double value(const Eigen::VectorXd& z, const std::vector<double>& weights, double barrier) const;

    /// The Gauss-Newton step: each sample keeps its edge line and weight.
    Eigen::VectorXd step(const Eigen::VectorXd& z, const std::vector<double>& weights, double barrier) const;

    /// The longest share of a step, at most 1, that uses up no more than 90 % of any gap.
    double longestShare(const Eigen::VectorXd& z, const Eigen::VectorXd& step) const;

private:
    Eigen::ArrayXd spareGaps(const Eigen::VectorXd& z) const;
    double meanSquare(const Eigen::VectorXd& z, const std::vector<double>& weights) const;
    double supportError(const Eigen::VectorXd& z, int i) const;
    double supportShare() const;

    /// Adds the second derivatives and the slope of both mean squares.
    void addDistances(const Eigen::VectorXd& z, const std::vector<double>& weights, Eigen::MatrixXd& hessian,
                      Eigen::VectorXd& gradient) const;
    void addSupports(const Eigen::VectorXd& z, Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const;

    const JointFrame& frame_;
    const EdgeLines& lines_;
    std::vector<double> supportValues_;
    Eigen::ArrayXd leastGaps_;
};

} // namespace chesil
