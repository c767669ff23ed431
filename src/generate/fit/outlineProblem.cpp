#include "generate/fit/outlineProblem.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace chesil
{

namespace
{

/// Points of each segment at which the distance is taken.
constexpr int samples = 24;

constexpr double supportWeight = 0.01;

double parameter(int k) { return (k + 0.5) / samples; }

} // namespace

OutlineProblem::OutlineProblem(const JointFrame& frame, const EdgeLines& lines,
                               std::vector<double> supportValues, Eigen::ArrayXd leastGaps)
    : frame_(frame), lines_(lines), supportValues_(std::move(supportValues)), leastGaps_(std::move(leastGaps))
{
}

std::vector<double> OutlineProblem::sampleWeights(const Eigen::VectorXd& z) const
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

double OutlineProblem::value(const Eigen::VectorXd& z, const std::vector<double>& weights,
                             double barrier) const
{
    const Eigen::ArrayXd gaps = spareGaps(z);
    if (!(gaps.minCoeff() > 0))
    {
        return std::numeric_limits<double>::infinity();
    }
    double sum = meanSquare(z, weights);
    for (int i = 0; i < frame_.joints(); ++i)
    {
        const double error = supportError(z, i);
        sum += supportShare() * error * error;
    }
    return sum / 2 - barrier * gaps.log().sum();
}

double OutlineProblem::distance(const Eigen::VectorXd& z) const
{
    return std::sqrt(meanSquare(z, sampleWeights(z)));
}

double OutlineProblem::meanSquare(const Eigen::VectorXd& z, const std::vector<double>& weights) const
{
    double sum = 0;
    std::size_t sample = 0;
    for (int i = 0; i < frame_.joints(); ++i)
    {
        const CubicBezier segment = frame_.segment(z, i);
        for (int k = 0; k < samples; ++k, ++sample)
        {
            const double away = lines_.distance(segment.at(parameter(k))).value;
            sum += weights[sample] * away * away;
        }
    }
    return sum;
}

std::vector<double> OutlineProblem::segmentErrors(const Eigen::VectorXd& z) const
{
    std::vector<double> errors;
    for (int i = 0; i < frame_.joints(); ++i)
    {
        const CubicBezier segment = frame_.segment(z, i);
        errors.push_back(0);
        for (int k = 0; k < samples; ++k)
        {
            const double away = lines_.distance(segment.at(parameter(k))).value;
            errors.back() += std::abs(away) * segment.derivative(parameter(k)).norm() / samples;
        }
    }
    return errors;
}

Eigen::VectorXd OutlineProblem::step(const Eigen::VectorXd& z, const std::vector<double>& weights,
                                     double barrier) const
{
    const Eigen::ArrayXd inverseGaps = spareGaps(z).inverse();
    const Eigen::MatrixXd& gapMatrix = frame_.gapMatrix();
    Eigen::MatrixXd hessian =
        gapMatrix.transpose() * (barrier * inverseGaps.square()).matrix().asDiagonal() * gapMatrix;
    Eigen::VectorXd gradient = -barrier * gapMatrix.transpose() * inverseGaps.matrix();
    addDistances(z, weights, hessian, gradient);
    addSupports(z, hessian, gradient);
    // A corner on a straight side may stand anywhere on it, and a straight segment does not use its handles.
    constexpr double damping = 1e-9;
    hessian.diagonal().array() += damping;
    return hessian.ldlt().solve(-gradient);
}

double OutlineProblem::longestShare(const Eigen::VectorXd& z, const Eigen::VectorXd& step) const
{
    const double use = -((frame_.gapMatrix() * step).array() / spareGaps(z)).minCoeff();
    return use > 0.9 ? 0.9 / use : 1;
}

Eigen::ArrayXd OutlineProblem::spareGaps(const Eigen::VectorXd& z) const
{
    return (frame_.gapMatrix() * z).array() - leastGaps_;
}

double OutlineProblem::supportError(const Eigen::VectorXd& z, int i) const
{
    return z[JointFrame::perJoint * i + JointFrame::offset] - supportValues_[static_cast<std::size_t>(i)];
}

double OutlineProblem::supportShare() const { return supportWeight / frame_.joints(); }

void OutlineProblem::addDistances(const Eigen::VectorXd& z, const std::vector<double>& weights,
                                  Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const
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

void OutlineProblem::addSupports(const Eigen::VectorXd& z, Eigen::MatrixXd& hessian,
                                 Eigen::VectorXd& gradient) const
{
    for (int i = 0; i < frame_.joints(); ++i)
    {
        const int place = JointFrame::perJoint * i + JointFrame::offset;
        hessian(place, place) += supportShare();
        gradient[place] += supportShare() * supportError(z, i);
    }
}

} // namespace chesil
