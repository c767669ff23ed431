#include "generate/fit/jointFrame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

Vector2 unitVector(double angle) { return Vector2(std::cos(angle), std::sin(angle)); }

} // namespace

JointFrame::JointFrame(const std::vector<PlannedJoint>& joints)
{
    for (const PlannedJoint& joint : joints)
    {
        const Vector2 normal = unitVector((joint.before + joint.after) / 2);
        const Vector2 last = joint.isCorner() ? unitVector(joint.before) : normal;
        const Vector2 first = joint.isCorner() ? unitVector(joint.after) : normal;
        axes_.push_back({normal, last, first, perpendicular(normal), perpendicular(last),
                         perpendicular(first), joint.isCorner(), joint.straightAfter});
    }
    const Eigen::Index size = perJoint * static_cast<Eigen::Index>(joints.size());
    gapMatrix_ = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < this->joints(); ++i)
    {
        addGaps(i);
    }
}

/// A joint's place along a direction, as a row to be multiplied by z.
Eigen::RowVectorXd JointFrame::coordinate(int i, const Vector2& direction) const
{
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(gapMatrix_.cols());
    row[perJoint * i + offset] = direction.dot(normal(i));
    // Exact for a smooth joint, whose tangent line does not know the joint's place on it
    row[perJoint * i + along] = isCorner(i) || direction != normal(i) ? direction.dot(tangent(i)) : 0;
    return row;
}

/// The line n.x = o, o = n.P_i, meets the line m.x = n_k.P_k at the distance (m.P_k - m.P_i) / (t.m) from P_i
/// along t.
void JointFrame::addGaps(int i)
{
    const auto wayToCrossing = [&](int k, const Vector2& otherNormal, const Vector2& way)
    {
        Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(gapMatrix_.cols());
        row += coordinate(k, otherNormal);
        row -= coordinate(i, otherNormal);
        return Eigen::RowVectorXd(row / way.dot(otherNormal));
    };
    const int first = perJoint * i;
    if (hasGap(i, 0))
    {
        gapMatrix_.row(first) =
            -wayToCrossing(previous(i), axes(previous(i)).normalAfter, axes(i).tangentBefore);
        gapMatrix_(first, first + before) -= 1;
        gapMatrix_(first + 1, first + before) = 1;
    }
    if (hasGap(i, 3))
    {
        gapMatrix_(first + 2, first + after) = 1;
        gapMatrix_.row(first + 3) = wayToCrossing(next(i), axes(next(i)).normalBefore, axes(i).tangentAfter);
        gapMatrix_(first + 3, first + after) -= 1;
    }
}

std::array<double, 2> JointFrame::edgeLengths(const Eigen::VectorXd& z, int i) const
{
    const auto length = [&](int part)
    {
        return hasGap(i, part) ? (gapMatrix_.middleRows(perJoint * i + part, 2) * z).sum()
                               : std::numeric_limits<double>::infinity();
    };
    return {length(0), length(2)};
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
    if (isStraight(i))
    {
        return CubicBezier::straight(start, end);
    }
    return CubicBezier({start, start + z[perJoint * i + after] * axes(i).tangentAfter,
                        end - z[perJoint * j + before] * axes(j).tangentBefore, end});
}

std::array<double, 2 * JointFrame::perJoint> JointFrame::pointGradient(int i, double t,
                                                                       const Vector2& direction) const
{
    const double s = 1 - t;
    const int j = next(i);
    const bool straight = isStraight(i);
    const double startWeight = straight ? s : s * s * (s + 3 * t);
    const double endWeight = straight ? t : t * t * (t + 3 * s);
    return {startWeight * direction.dot(normal(i)),
            startWeight * direction.dot(tangent(i)),
            0,
            straight ? 0 : 3 * s * s * t * direction.dot(axes(i).tangentAfter),
            endWeight * direction.dot(normal(j)),
            endWeight * direction.dot(tangent(j)),
            straight ? 0 : -3 * s * t * t * direction.dot(axes(j).tangentBefore),
            0};
}

Eigen::VectorXd JointFrame::atPoints(const std::vector<Vector2>& points) const
{
    Eigen::VectorXd z = Eigen::VectorXd::Zero(perJoint * joints());
    for (int i = 0; i < joints(); ++i)
    {
        const Vector2& point = points[static_cast<std::size_t>(i)];
        z[perJoint * i + offset] = point.dot(normal(i));
        z[perJoint * i + along] = point.dot(tangent(i));
    }
    return z;
}

Eigen::VectorXd JointFrame::withHandles(const Eigen::VectorXd& lines) const
{
    Eigen::VectorXd z = lines;
    for (int i = 0; i < joints(); ++i)
    {
        auto [from, to] = edgeLengths(lines, i);
        if (!isCorner(i))
        {
            const double margin = 0.25 * (from + to);
            const double move = std::clamp(0.0, margin - from, to - margin);
            z[perJoint * i + along] += move;
            from += move;
            to -= move;
        }
        z[perJoint * i + before] = hasGap(i, 0) ? 0.5 * from : 0;
        z[perJoint * i + after] = hasGap(i, 3) ? 0.5 * to : 0;
    }
    return z;
}

} // namespace chesil
