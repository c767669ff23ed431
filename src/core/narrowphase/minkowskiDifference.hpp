#pragma once

#include "core/base/pose.hpp"
#include "core/base/supportContract.hpp"
#include "core/base/twoLanes.hpp"
#include "core/base/vector.hpp"
#include "core/narrowphase/partWalk.hpp"
#include "core/narrowphase/queryCost.hpp"

#include <algorithm>
#include <type_traits>

namespace chesil
{

/// A vertex of A - B with the two points it came from, all relative to A's centroid, world axes [m].
template <int Dim>
struct SupportVertex
{
    Vector<Dim> difference;
    Vector<Dim> onA;
};

/// The same with how A - B bends there, and A alone.
template <int Dim>
struct CurvedVertex
{
    Vector<Dim> difference;
    Vector<Dim> onA;
    CurvatureRadius radius;
    CurvatureRadius radiusA;
    /// How far the normal may turn before either outline is another curve [rad].
    double room;
};

/// A straight side of A - B: its outward unit normal and both ends, the clockwise one first. World axes [m].
struct DifferenceSide
{
    Vector2 normal;
    CurvedVertex<2> start;
    CurvedVertex<2> end;
};

/// The set A - B of two placed convex shapes through its support points: all that the solvers know of
/// them. What the shapes offer: core/base/supportContract.hpp. Coordinates are relative to A's centroid, so that a
/// scene far from the origin loses no digits. The set holds the origin where the shapes overlap.
template <int Dim, class ShapeA, class ShapeB, class Cost = NoCost>
class MinkowskiDifference : private Cost
{
public:
    static constexpr bool offersCurvature = OffersCurvature<ShapeA>::value && OffersCurvature<ShapeB>::value;

    MinkowskiDifference(const ShapeA& a, const Pose<Dim>& poseA, const ShapeB& b, const Pose<Dim>& poseB, Cost counter = {}, PieceGuess pieces = {})
    : Cost(counter), a_(a), b_(b), rotationA_(poseA.rotation), rotationB_(poseB.rotation), centreToCentre_(poseB.position - poseA.position),
      pieces_(pieces)
    {
    }

    /// Point of A - B furthest along `direction` (any length but zero).
    SupportVertex<Dim> support(const Vector<Dim>& direction) const
    {
        Cost::countSupport();
        const Vector<Dim> onA = rotationA_.apply(a_.support(rotationA_.applyInverse(direction)));
        const Vector<Dim> onB = rotationB_.apply(b_.support(rotationB_.applyInverse(-direction)));
        return {onA - onB - centreToCentre_, onA};
    }

    /// The same along a unit normal, with curvature.
    CurvedVertex<Dim> curvedSupport(const Vector<Dim>& normal) const
    {
        Cost::countSupport();
        if constexpr (std::is_same_v<ShapeA, ShapeB> && OffersPairedSupport<ShapeA>::value)
        {
            return curvedSupportSideBySide(normal);
        }
        else
        {
            return joined(curvedOnA(normal), curvedOnB(normal));
        }
    }

    /// From A's centroid to B's [m].
    const Vector<Dim>& centreToCentre() const { return centreToCentre_; }

    /// Sum of both bounding radii [m]: what tolerances are relative to.
    double size() const { return a_.boundingRadius() + b_.boundingRadius(); }

    /// Lower bound of the radius of curvature of the set's whole boundary [m].
    double leastRadius() const { return a_.leastRadius() + b_.leastRadius(); }

    /// A disk of this radius [m] about -centreToCentre() lies in the set.
    double innerRadius() const { return a_.innerRadius() + b_.innerRadius(); }

    /// Lower bound of the radius of curvature of the set's boundary between two normals [m].
    double leastRadiusBetween(const Vector2& first, const Vector2& last) const
    {
        return a_.leastRadiusBetween(rotationA_.applyInverse(first), rotationA_.applyInverse(last))
            + b_.leastRadiusBetween(rotationB_.applyInverse(-first), rotationB_.applyInverse(-last));
    }

    /// Round the outlines of A and of -B from a unit normal on.
    PartWalk<ShapeA> walkA(const Vector2& normal, int sense) const { return {a_, rotationA_, 1, normal, sense}; }
    PartWalk<ShapeB> walkB(const Vector2& normal, int sense) const { return {b_, rotationB_, -1, normal, sense}; }

    /// A straight side of the set between two normals (as a shape's straightSideBetween), made of a side of one shape
    /// and a point of the other: the one nearer to `from`. False if there is none.
    bool straightSideBetween(const Vector2& from, const Vector2& to, DifferenceSide& side) const
    {
        const StraightSide* ofA = nullptr;
        const StraightSide* ofB = nullptr;
        if constexpr (ShapeA::mayHaveStraightSides)
        {
            ofA = a_.hasStraightSides()
                ? a_.straightSideBetween(rotationA_.applyInverse(from), rotationA_.applyInverse(to))
                : nullptr;
        }
        if constexpr (ShapeB::mayHaveStraightSides)
        {
            ofB = b_.hasStraightSides()
                ? b_.straightSideBetween(rotationB_.applyInverse(-from), rotationB_.applyInverse(-to))
                : nullptr;
        }
        if (ofA && ofB)
        {
            const double turnA = std::abs(cross(from, rotationA_.apply(ofA->normal)));
            const double turnB = std::abs(cross(from, rotationB_.apply(ofB->normal)));
            (turnA <= turnB ? ofB : ofA) = nullptr;
        }
        if (!ofA && !ofB)
        {
            return false;
        }
        Cost::countSupport();
        if (ofA)
        {
            side.normal = rotationA_.apply(ofA->normal);
            const CurvedPoint<2> onB = curvedOnB(side.normal);
            side.start = joined({rotationA_.apply(ofA->start), {}, 0}, onB);
            side.end = joined({rotationA_.apply(ofA->end), {}, 0}, onB);
        }
        else
        {
            side.normal = -rotationB_.apply(ofB->normal);
            const CurvedPoint<2> onA = curvedOnA(side.normal);
            side.start = joined(onA, {rotationB_.apply(ofB->start), {}, 0});
            side.end = joined(onA, {rotationB_.apply(ofB->end), {}, 0});
        }
        return true;
    }

    static constexpr bool mayHaveStraightSides()
    {
        if constexpr (offersCurvature)
        {
            return ShapeA::mayHaveStraightSides || ShapeB::mayHaveStraightSides;
        }
        return false;
    }

    /// Those of the last curved support point, where the shapes tell.
    const PieceGuess& pieces() const { return pieces_; }

    void countSweep() const { Cost::countSweep(); }

private:
    CurvedVertex<2> curvedSupportSideBySide(const Vector2& normal) const
    {
        const Vector2 turnA = rotationA_.direction();
        const Vector2 turnB = rotationB_.direction();
        const TwoLanes cosine{turnA.x(), turnB.x()};
        const TwoLanes sine{turnA.y(), turnB.y()};
        const TwoLanes x{normal.x(), -normal.x()};
        const TwoLanes y{normal.y(), -normal.y()};
        const auto found = ShapeA::curvedSupports(a_, b_, cosine * x + sine * y, cosine * y - sine * x, pieces_);
        const TwoLanes worldX = cosine * found.x - sine * found.y;
        const TwoLanes worldY = sine * found.x + cosine * found.y;
        const CurvatureRadius radiusA{found.radius[0], found.radiusFirst[0], found.radiusSecond[0]};
        const CurvatureRadius radiusB{found.radius[1], found.radiusFirst[1], found.radiusSecond[1]};
        return {
            Vector2(worldX[0] - worldX[1] - centreToCentre_.x(), worldY[0] - worldY[1] - centreToCentre_.y()),
            Vector2(worldX[0], worldY[0]),
            radiusA + radiusB,
            radiusA,
            std::min(found.room[0], found.room[1])};
    }

    CurvedPoint<Dim> curvedOnA(const Vector<Dim>& normal) const
    {
        const CurvedPoint<Dim> local = a_.curvedSupport(rotationA_.applyInverse(normal));
        return {rotationA_.apply(local.point), local.radius, local.room};
    }

    CurvedPoint<Dim> curvedOnB(const Vector<Dim>& normal) const
    {
        const CurvedPoint<Dim> local = b_.curvedSupport(rotationB_.applyInverse(-normal));
        return {rotationB_.apply(local.point), local.radius, local.room};
    }

    CurvedVertex<Dim> joined(const CurvedPoint<Dim>& onA, const CurvedPoint<Dim>& onB) const
    {
        return {
            onA.point - onB.point - centreToCentre_, onA.point, onA.radius + onB.radius, onA.radius, std::min(onA.room, onB.room)};
    }

    const ShapeA& a_;
    const ShapeB& b_;
    const Rotation<Dim>& rotationA_;
    const Rotation<Dim>& rotationB_;
    Vector<Dim> centreToCentre_;
    mutable PieceGuess pieces_;
};

} // namespace chesil
