#pragma once

#include "core/base/vector.hpp"
#include "core/geometry/cubicBezier.hpp"

#include <Eigen/Dense>

#include <array>
#include <vector>

namespace chesil
{

/// Smooth convex outlines whose joints have given outward normals n_i, described by four numbers a joint,
/// all lengths in the frame of the outline (z = 4 N numbers, joint after joint):
///
///     offset  distance of the joint's tangent line from the origin, along n_i
///     along   place of the joint on this line, along the tangent t_i (n_i turned by +90 degrees)
///     before  distance from Q2 of the segment that ends here to the joint
///     after   distance from the joint to Q1 of the segment that starts here
///
/// On tangent line i the following points stand in this order: the crossing R with line i-1, Q2, the joint,
/// Q1, the crossing R with line i+1. The outline is convex and G1 exactly if the four gaps between them are
/// positive. Control points and gaps are linear in z, so that fitting is linear least squares under
/// linear inequalities. Replaces x1, x2 of Lai & Huang, section 4, where the joints stand still.
class JointFrame
{
public:
    static constexpr int perJoint = 4;
    enum Part
    {
        offset,
        along,
        before,
        after
    };

    /// `angles` [rad] of the normals, rising, over one turn, neighbours less than pi apart.
    explicit JointFrame(const std::vector<double>& angles);

    int joints() const { return static_cast<int>(normals_.size()); }
    const Vector2& normal(int i) const { return normals_[static_cast<std::size_t>(i)]; }
    const Vector2& tangent(int i) const { return tangents_[static_cast<std::size_t>(i)]; }
    int next(int i) const { return i + 1 == joints() ? 0 : i + 1; }

    /// The 4 N gaps of z are gapMatrix() * z, in the order told above.
    const Eigen::MatrixXd& gapMatrix() const { return gapMatrix_; }

    /// Length of tangent line i between its two crossings.
    double edgeLength(const Eigen::VectorXd& z, int i) const;

    /// Segment i, from joint i to the next. Control points beside a joint are the joint plus a length times
    /// the unit tangent, which keeps the two tangents of a joint equal to rounding.
    CubicBezier segment(const Eigen::VectorXd& z, int i) const;

    /// d(direction . B_i(t)) / dz: its 8 entries that are not zero, for joint i and for the next one.
    std::array<double, 2 * perJoint> pointGradient(int i, double t, const Vector2& direction) const;

    /// z of tangent lines at these distances from the origin; joints at along = 0, no handles.
    Eigen::VectorXd tangentLines(const std::vector<double>& offsets) const;

    /// z of the outline with tangent lines at these distances, whose edges must have positive lengths, with
    /// each joint as near to `wantedJoints` as a quarter of its edge allows, and handles of half the way to
    /// the crossings.
    Eigen::VectorXd start(const std::vector<double>& offsets, const std::vector<Vector2>& wantedJoints) const;

private:
    Vector2 joint(const Eigen::VectorXd& z, int i) const;

    std::vector<Vector2> normals_;
    std::vector<Vector2> tangents_;
    Eigen::MatrixXd gapMatrix_;
};

} // namespace chesil
