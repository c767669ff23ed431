#pragma once

#include "core/base/pose.hpp"
#include "core/narrowphase/gjk.hpp"
#include "unit/randomGrain.hpp"

#include <cmath>

namespace chesil::benchmark
{

/// Poses of two overlapping shapes, and the direction in which a time loop would look for their contact
/// first.
struct OverlappingPoses
{
    Pose<2> a;
    Pose<2> b;
    Vector2 lookFirst = Vector2::Zero();
};

template <class ShapeA, class ShapeB>
bool overlap(const ShapeA& a, const ShapeB& b, const OverlappingPoses& poses)
{
    const MinkowskiDifference<2, ShapeA, ShapeB> difference(a, poses.a, b, poses.b);
    return gjk<2>(difference, poses.lookFirst).status == GjkStatus::overlapping;
}

/// Random angles and a random contact normal n. The support points of A along n and of B along -n are laid
/// `depth` times the sum of the bounding radii over each other: just that is the penetration depth of a
/// shallow pair of smooth shapes, and a bound of it for polygons. To be looked for along last step's normal:
/// n turned by up to 0.01 rad.
template <class ShapeA, class ShapeB>
OverlappingPoses shallowPoses(const ShapeA& a, const ShapeB& b, double depth, test::RandomSource& random)
{
    for (;;)
    {
        OverlappingPoses poses;
        poses.a = random.pose(1);
        poses.b = random.pose(1);
        const Vector2 normal = random.direction();
        const Vector2 onA = poses.a.rotation.apply(a.support(poses.a.rotation.applyInverse(normal)));
        const Vector2 onB = poses.b.rotation.apply(b.support(poses.b.rotation.applyInverse(-normal)));
        const double overlapping = depth * (a.boundingRadius() + b.boundingRadius());
        poses.b.position = poses.a.position + onA - onB - overlapping * normal;
        poses.lookFirst = Rotation<2>(random.uniform(-0.01, 0.01)).apply(normal);
        if (overlap(a, b, poses))
        {
            return poses;
        }
    }
}

/// Centroids 5..50 % of the sum of the bounding radii apart. To be looked for from centroid to centroid.
template <class ShapeA, class ShapeB>
OverlappingPoses deepPoses(const ShapeA& a, const ShapeB& b, test::RandomSource& random)
{
    for (;;)
    {
        OverlappingPoses poses;
        poses.a = random.pose(1);
        poses.b = random.pose(1);
        const double distance = random.uniform(0.05, 0.5) * (a.boundingRadius() + b.boundingRadius());
        poses.lookFirst = distance * random.direction();
        poses.b.position = poses.a.position + poses.lookFirst;
        if (overlap(a, b, poses))
        {
            return poses;
        }
    }
}

} // namespace chesil::benchmark
