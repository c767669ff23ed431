#pragma once

#include "core/base/vector.hpp"
#include "core/geometry/cubicBezier.hpp"
#include "generate/fit/jointPlan.hpp"

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
///
/// A corner is a joint with a range of normals, from n_b of the segment that ends here to n_a of the one that
/// starts here. It has two tangent lines, both through the corner: Q2 stands on the one, Q1 on the other;
/// `offset` and `along` are its coordinates along the normal half way between and across. A straight segment
/// between two corners has no handles: their entries and gaps are not used, and zero.
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

    /// Normals rising over one turn, neighbours less than pi apart.
    explicit JointFrame(const std::vector<PlannedJoint>& joints);

    int joints() const { return static_cast<int>(axes_.size()); }
    /// Half way between the normals before and after the joint.
    const Vector2& normal(int i) const { return axes(i).normal; }
    const Vector2& tangent(int i) const { return axes(i).tangent; }
    bool isCorner(int i) const { return axes(i).isCorner; }
    /// The segment that starts at the joint.
    bool isStraight(int i) const { return axes(i).straightAfter; }
    int next(int i) const { return i + 1 == joints() ? 0 : i + 1; }

    /// The 4 N gaps of z are gapMatrix() * z, in the order told above.
    const Eigen::MatrixXd& gapMatrix() const { return gapMatrix_; }

    /// Gap `part` (0 to 3) of joint i is used.
    bool hasGap(int i, int part) const { return !isStraight(part < 2 ? previous(i) : i); }

    /// Lengths of tangent line i from the crossing before to the joint and from there to the crossing behind;
    /// infinite beside a straight segment.
    std::array<double, 2> edgeLengths(const Eigen::VectorXd& z, int i) const;

    /// Segment i, from joint i to the next. Control points beside a joint are the joint plus a length times
    /// the unit tangent, which keeps the two tangents of a joint equal to rounding.
    CubicBezier segment(const Eigen::VectorXd& z, int i) const;

    /// d(direction . B_i(t)) / dz: its 8 entries that are not zero, for joint i and for the next one.
    std::array<double, 2 * perJoint> pointGradient(int i, double t, const Vector2& direction) const;

    /// z of joints at these points, one a joint, without handles.
    Eigen::VectorXd atPoints(const std::vector<Vector2>& points) const;

    /// z of the outline whose tangent lines and corners are those of `lines`, with pieces of positive lengths
    /// between the crossings, each smooth joint as near to its place in `lines` as a quarter of its piece
    /// allows, and handles of half the way to the crossings.
    Eigen::VectorXd withHandles(const Eigen::VectorXd& lines) const;

private:
    struct Axes
    {
        Vector2 normal, normalBefore, normalAfter;
        Vector2 tangent, tangentBefore, tangentAfter;
        bool isCorner, straightAfter;
    };

    int previous(int i) const { return i == 0 ? joints() - 1 : i - 1; }
    const Axes& axes(int i) const { return axes_[static_cast<std::size_t>(i)]; }
    Eigen::RowVectorXd coordinate(int i, const Vector2& direction) const;
    void addGaps(int i);
    Vector2 joint(const Eigen::VectorXd& z, int i) const;

    std::vector<Axes> axes_;
    Eigen::MatrixXd gapMatrix_;
};

} // namespace chesil
