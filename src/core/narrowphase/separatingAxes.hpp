#pragma once

#include "core/base/pose.hpp"
#include "core/base/supportContract.hpp"
#include "core/narrowphase/penetration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace chesil
{

/// A convex shape of vertices with a rim of constant width: a polygon (no rim), or a disk (one vertex, all rim).
struct VertexLoop
{
    /// Side i starts at vertex i; the one side of a disk has no length.
    const StraightSide* sides;
    std::size_t size;
    /// [m]
    double rim;

    bool isPolygon() const { return size > 1; }
};

/// Most vertices for which trying all axes is the fastest way.
constexpr std::size_t mostAxes = 16;

/// Penetration of two loops of up to mostAxes vertices, at most one of them a disk, by separating axes: exact but for
/// rounding, with no search and hardly a branch. The depth is the least over all sides of both; a disk
/// whose centre lies outside may be nearer to a vertex. Gottschalk et al. 1996.
class SeparatingAxes
{
public:
    SeparatingAxes(const VertexLoop& a, const Pose<2>& poseA, const VertexLoop& b, const Pose<2>& poseB)
    : a_(a), b_(b), poseA_(poseA), poseB_(poseB), centreToCentre_(poseB.position - poseA.position)
    {
    }

    Penetration<2> contact() const
    {
        const Axis ofA = a_.isPolygon() ? widestGap(a_, poseA_.rotation, b_, poseB_.rotation, centreToCentre_) : none();
        const Axis ofB = b_.isPolygon() ? widestGap(b_, poseB_.rotation, a_, poseA_.rotation, -centreToCentre_) : none();
        const bool sideOfA = ofA.gap >= ofB.gap;
        const Axis& axis = sideOfA ? ofA : ofB;
        const double rim = a_.rim + b_.rim;
        if (!std::isfinite(axis.gap))
        {
            return {PairStatus::notFinite, Vector2::UnitX(), 0, Vector2::Zero()};
        }
        if (axis.gap > 0 && rim > axis.gap)
        {
            return diskOutside(sideOfA, axis.side);
        }
        const VertexLoop& loop = sideOfA ? a_ : b_;
        const Rotation<2>& rotation = (sideOfA ? poseA_ : poseB_).rotation;
        const Vector2 outward = rotation.apply(loop.sides[axis.side].normal);
        return ended(sideOfA, sideOfA ? outward : Vector2(-outward), rim - axis.gap, deepest(sideOfA, axis));
    }

private:
    struct Axis
    {
        std::size_t side;
        /// Largest over the loop's sides of the gap between the side and the other's vertices [m].
        double gap;
        /// The other's vertex nearest to that side's line.
        std::size_t vertex;
    };

    static Axis none() { return {0, -std::numeric_limits<double>::infinity(), 0}; }

    /// In the frame of the loop whose sides are tried.
    static Axis widestGap(
        const VertexLoop& loop, const Rotation<2>& rotation, const VertexLoop& other, const Rotation<2>& otherRotation, const Vector2& offset)
    {
        std::array<Vector2, mostAxes> vertices;
        for (std::size_t j = 0; j < other.size; ++j)
        {
            vertices[j] = rotation.applyInverse(otherRotation.apply(other.sides[j].start) + offset);
        }
        Axis widest = none();
        for (std::size_t i = 0; i < loop.size; ++i)
        {
            const StraightSide& side = loop.sides[i];
            double lowest = side.normal.dot(vertices[0] - side.start);
            for (std::size_t j = 1; j < other.size; ++j)
            {
                lowest = std::min(lowest, side.normal.dot(vertices[j] - side.start));
            }
            widest.side = lowest > widest.gap ? i : widest.side;
            widest.gap = std::max(lowest, widest.gap);
        }
        const StraightSide& side = loop.sides[widest.side];
        for (std::size_t j = 1; j < other.size; ++j)
        {
            widest.vertex = side.normal.dot(vertices[j]) < side.normal.dot(vertices[widest.vertex]) ? j : widest.vertex;
        }
        return widest;
    }

    /// The other loop's deepest vertex, relative to A's centroid, world axes [m].
    Vector2 deepest(bool sideOfA, const Axis& axis) const
    {
        return sideOfA ? Vector2(poseB_.rotation.apply(b_.sides[axis.vertex].start) + centreToCentre_)
                       : poseA_.rotation.apply(a_.sides[axis.vertex].start);
    }

    /// `vertex` is the deepest of the loop that does not own the side.
    Penetration<2> ended(bool sideOfA, const Vector2& normal, double depth, const Vector2& vertex) const
    {
        const PairStatus status = depth > 0 ? PairStatus::overlapping : PairStatus::separated;
        const double shift = sideOfA ? depth / 2 - b_.rim : a_.rim - depth / 2;
        return {status, normal, depth, vertex + shift * normal};
    }

    /// The disk's centre lies outside, nearest to this side or to one of its ends.
    Penetration<2> diskOutside(bool sideOfA, std::size_t i) const
    {
        const StraightSide& side = (sideOfA ? a_ : b_).sides[i];
        const Pose<2>& pose = sideOfA ? poseA_ : poseB_;
        const Vector2 centre = pose.rotation.applyInverse(sideOfA ? centreToCentre_ : Vector2(-centreToCentre_));
        const Vector2 edge = side.end - side.start;
        const double share = std::min(1.0, std::max(0.0, (centre - side.start).dot(edge) / edge.squaredNorm()));
        const bool onSide = share > 0 && share < 1;
        const Vector2 toCentre = centre - (share < 1 ? side.start : side.end);
        const double distance = onSide ? side.normal.dot(toCentre) : toCentre.norm();
        const Vector2 outward = pose.rotation.apply(onSide ? side.normal : Vector2(toCentre / distance));
        const Vector2 vertex = sideOfA ? centreToCentre_ : Vector2(Vector2::Zero());
        return ended(sideOfA, sideOfA ? outward : Vector2(-outward), a_.rim + b_.rim - distance, vertex);
    }

    const VertexLoop& a_;
    const VertexLoop& b_;
    const Pose<2>& poseA_;
    const Pose<2>& poseB_;
    Vector2 centreToCentre_;
};

} // namespace chesil
