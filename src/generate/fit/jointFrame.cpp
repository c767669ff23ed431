#include "generate/fit/jointFrame.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

JointFrame::JointFrame(const std::vector<double>& angles)
{
    for (const double angle : angles)
    {
        normals_.emplace_back(std::cos(angle), std::sin(angle));
        tangents_.push_back(perpendicular(normals_.back()));
    }

    // Line i is n_i.x = offset_i. It meets line k at the distance
    //     (offset_k - offset_i n_i.n_k) / (t_i.n_k)
    // along t_i; t_i.n_k is the sine of the turn from i to k.
    gapMatrix_ = Eigen::MatrixXd::Zero(perJoint * joints(), perJoint * joints());
    for (int i = 0; i < joints(); ++i)
    {
        const int previous = i == 0 ? joints() - 1 : i - 1;
        const auto crossing = [&](int k)
        {
            Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(perJoint * joints());
            const double sine = tangent(i).dot(normal(k));
            row[perJoint * k + offset] += 1 / sine;
            row[perJoint * i + offset] -= normal(i).dot(normal(k)) / sine;
            return row;
        };
        const int first = perJoint * i;
        gapMatrix_.row(first) = -crossing(previous);
        gapMatrix_(first, first + along) += 1;
        gapMatrix_(first, first + before) -= 1;
        gapMatrix_(first + 1, first + before) = 1;
        gapMatrix_(first + 2, first + after) = 1;
        gapMatrix_.row(first + 3) = crossing(next(i));
        gapMatrix_(first + 3, first + along) -= 1;
        gapMatrix_(first + 3, first + after) -= 1;
    }
}

double JointFrame::edgeLength(const Eigen::VectorXd& z, int i) const
{
    return (gapMatrix_.middleRows(perJoint * i, perJoint) * z).sum();
}

Vector2 JointFrame::joint(const Eigen::VectorXd& z, int i) const
{
    return z[perJoint * i + offset] * normal(i) + z[perJoint * i + along] * tangent(i);
}

CubicBezier JointFrame::segment(const Eigen::VectorXd& z, int i) const
{
    const int j = next(i);
    const Vector2 start = joint(z, i);
    const Vector2 end = joint(z, j);
    return CubicBezier({start, start + z[perJoint * i + after] * tangent(i),
                        end - z[perJoint * j + before] * tangent(j), end});
}

std::array<double, 2 * JointFrame::perJoint> JointFrame::pointGradient(int i, double t,
                                                                       const Vector2& direction) const
{
    const double s = 1 - t;
    const double startWeight = s * s * (s + 3 * t);
    const double endWeight = t * t * (t + 3 * s);
    const int j = next(i);
    const double alongStart = direction.dot(tangent(i));
    const double alongEnd = direction.dot(tangent(j));
    return {startWeight * direction.dot(normal(i)),
            startWeight * alongStart,
            0,
            3 * s * s * t * alongStart,
            endWeight * direction.dot(normal(j)),
            endWeight * alongEnd,
            -3 * s * t * t * alongEnd,
            0};
}

Eigen::VectorXd JointFrame::tangentLines(const std::vector<double>& offsets) const
{
    Eigen::VectorXd z = Eigen::VectorXd::Zero(perJoint * joints());
    for (int i = 0; i < joints(); ++i)
    {
        z[perJoint * i + offset] = offsets[static_cast<std::size_t>(i)];
    }
    return z;
}

Eigen::VectorXd JointFrame::start(const std::vector<double>& offsets,
                                  const std::vector<Vector2>& wantedJoints) const
{
    Eigen::VectorXd z = tangentLines(offsets);
    // The outer gaps of joints at along = 0 without handles tell where the crossings are.
    const Eigen::VectorXd gaps = gapMatrix_ * z;
    for (int i = 0; i < joints(); ++i)
    {
        const double from = -gaps[perJoint * i];
        const double to = gaps[perJoint * i + 3];
        const double margin = 0.25 * (to - from);
        const double wanted = wantedJoints[static_cast<std::size_t>(i)].dot(tangent(i));
        const double place = std::clamp(wanted, from + margin, to - margin);
        z[perJoint * i + along] = place;
        z[perJoint * i + before] = 0.5 * (place - from);
        z[perJoint * i + after] = 0.5 * (to - place);
    }
    return z;
}

} // namespace chesil
