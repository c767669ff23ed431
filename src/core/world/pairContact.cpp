#include "core/world/pairContact.hpp"

#include "core/world/diskContact.hpp"
#include "core/narrowphase/firstNormal.hpp"
#include "core/narrowphase/separatingAxes.hpp"

#include <cmath>

namespace chesil
{

namespace
{

VertexLoop loopOf(const ConvexPolygon& polygon)
{
    return {polygon.sides().data(), polygon.sides().size(), 0};
}

VertexLoop loopOf(const Circle& circle)
{
    static const StraightSide centre{Vector2::UnitX(), Vector2::Zero(), Vector2::Zero()};
    return {&centre, 1, circle.radius()};
}

template <class ShapeType>
constexpr bool isLoop = std::is_same_v<ShapeType, Circle> || std::is_same_v<ShapeType, ConvexPolygon>;

/// By axes, by valley or by expansion, whichever the two shapes allow; their bounding circles overlap.
template <class ShapeA, class ShapeB, class Difference>
Penetration<2> search(
    const ShapeA& a, const Pose<2>& poseA, const ShapeB& b, const Pose<2>& poseB, const Difference& difference, const SearchStart& start)
{
    const Vector2& centreToCentre = difference.centreToCentre();
    if constexpr (isLoop<ShapeA> && isLoop<ShapeB>)
    {
        const VertexLoop loopA = loopOf(a);
        const VertexLoop loopB = loopOf(b);
        if (std::max(loopA.size, loopB.size) <= mostAxes)
        {
            const Vector2& direction = start.direction;
            // Last step's direction most often still separates what it separated then.
            if (direction != Vector2::Zero() && direction.allFinite())
            {
                const double reach = direction.dot(difference.support(direction).difference);
                if (reach < 0)
                {
                    return {PairStatus::separated, direction, reach, Vector2::Zero()};
                }
            }
            return SeparatingAxes(loopA, poseA, loopB, poseB).contact();
        }
    }
    if constexpr (Difference::offersCurvature)
    {
        return penetration(difference, firstNormal<2>(start.expected(), centreToCentre));
    }
    else
    {
        return penetrationByExpansion<2>(difference, firstNormal<2>(start.expected(), centreToCentre));
    }
}

template <class ShapeA, class ShapeB, class Cost>
PairStatus contactOf(
    const ShapeA& a,
    const Pose<2>& poseA,
    const ShapeB& b,
    const Pose<2>& poseB,
    SearchStart& start,
    ContactGeometry<2>& contact,
    Cost cost)
{
    const MinkowskiDifference<2, ShapeA, ShapeB, Cost> difference(a, poseA, b, poseB, cost, start.pieces);
    const double squaredDistance = difference.centreToCentre().squaredNorm();
    if (!(squaredDistance <= difference.size() * difference.size()))
    {
        return std::isfinite(squaredDistance) ? PairStatus::separated : PairStatus::notFinite;
    }
    const Penetration<2> found = search(a, poseA, b, poseB, difference, start);
    start.pieces = difference.pieces();
    if (found.status == PairStatus::notFinite || found.status == PairStatus::undecided)
    {
        return found.status;
    }
    if (found.status == PairStatus::separated)
    {
        start.standAt(found.normal);
    }
    else
    {
        start.turnTo(found.normal);
        contact.depth = found.depth;
        contact.normal = found.normal;
        contact.point = poseA.position + found.point;
    }
    return found.status;
}

template <class Cost>
PairStatus contactOf(
    const Circle& a, const Pose<2>& poseA, const Circle& b, const Pose<2>& poseB, SearchStart&, ContactGeometry<2>& contact, Cost)
{
    const Vector2 between = poseB.position - poseA.position;
    if (!between.allFinite())
    {
        return PairStatus::notFinite;
    }
    return diskContact(poseA.position, between, a.radius(), b.radius(), contact) ? PairStatus::overlapping : PairStatus::separated;
}

/// Not inlined, so that what it puts on the stack costs pairs of disks nothing.
template <class Cost>
[[gnu::noinline]] PairStatus visited(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    SearchStart& start,
    ContactGeometry<2>& contact,
    Cost cost)
{
    return std::visit(
        [&](const auto& shapeA, const auto& shapeB)
        { return contactOf(shapeA, poseA, shapeB, poseB, start, contact, cost); },
        a,
        b);
}

/// Disks go ahead of the table of all pairs: they are so cheap that the jump through it would show.
template <class Cost>
PairStatus disksFirst(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    SearchStart& start,
    ContactGeometry<2>& contact,
    Cost cost)
{
    const Circle* diskA = std::get_if<Circle>(&a);
    const Circle* diskB = std::get_if<Circle>(&b);
    return diskA && diskB ? contactOf(*diskA, poseA, *diskB, poseB, start, contact, cost)
                          : visited(a, poseA, b, poseB, start, contact, cost);
}

} // namespace

PairStatus pairContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    SearchStart& start,
    ContactGeometry<2>& contact)
{
    return disksFirst(a, poseA, b, poseB, start, contact, NoCost{});
}

PairStatus pairContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    SearchStart& start,
    ContactGeometry<2>& contact,
    QueryCost& cost)
{
    return disksFirst(a, poseA, b, poseB, start, contact, CostCounter{&cost});
}

} // namespace chesil
