#pragma once

#include "core/base/pose.hpp"
#include "core/base/vector.hpp"

namespace chesil
{

/// A vertex of A - B with the two points it came from, all relative to A's centroid, world axes [m].
template <int Dim>
struct SupportVertex
{
    Vector<Dim> difference;
    Vector<Dim> onA;
};

/// The set A - B of two placed convex shapes through its support points: all that GJK and EPA know of
/// them. A shape offers support(direction) in its own frame and boundingRadius(). Coordinates are relative
/// to A's centroid, so that a scene far from the origin loses no digits.
template <int Dim, class ShapeA, class ShapeB>
class MinkowskiDifference
{
public:
    MinkowskiDifference(const ShapeA& a, const Pose<Dim>& poseA, const ShapeB& b, const Pose<Dim>& poseB)
    : a_(a), b_(b), rotationA_(poseA.rotation), rotationB_(poseB.rotation), centreToCentre_(poseB.position - poseA.position)
    {
    }

    /// Point of A - B furthest along `direction` (any length but zero).
    SupportVertex<Dim> support(const Vector<Dim>& direction) const
    {
        const Vector<Dim> onA = rotationA_.apply(a_.support(rotationA_.applyInverse(direction)));
        const Vector<Dim> onB = rotationB_.apply(b_.support(rotationB_.applyInverse(-direction)));
        return {onA - onB - centreToCentre_, onA};
    }

    /// From A's centroid to B's [m].
    const Vector<Dim>& centreToCentre() const { return centreToCentre_; }

    /// Sum of both bounding radii [m]: what tolerances are relative to.
    double size() const { return a_.boundingRadius() + b_.boundingRadius(); }

private:
    const ShapeA& a_;
    const ShapeB& b_;
    const Rotation<Dim>& rotationA_;
    const Rotation<Dim>& rotationB_;
    Vector<Dim> centreToCentre_;
};

} // namespace chesil
