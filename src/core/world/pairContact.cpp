#include "core/world/pairContact.hpp"

#include "core/narrowphase/epa.hpp"
#include "core/narrowphase/gjk.hpp"

#include <cmath>

namespace chesil
{

namespace
{

PairStatus contactOf(
    const Circle& a, const Pose<2>& poseA, const Circle& b, const Pose<2>& poseB, Vector2&, ContactGeometry<2>& contact)
{
    const Vector2 offset = poseB.position - poseA.position;
    const double distance = offset.norm();
    if (!std::isfinite(distance))
    {
        return PairStatus::notFinite;
    }
    const double depth = a.radius() + b.radius() - distance;
    if (!(depth > 0))
    {
        return PairStatus::separated;
    }
    contact.depth = depth;
    contact.normal = distance > 0 ? Vector2(offset / distance) : Vector2(Vector2::UnitX());
    contact.point = poseA.position + (a.radius() - depth / 2) * contact.normal;
    return PairStatus::overlapping;
}

template <class ShapeA, class ShapeB>
PairStatus contactOf(
    const ShapeA& a,
    const Pose<2>& poseA,
    const ShapeB& b,
    const Pose<2>& poseB,
    Vector2& direction,
    ContactGeometry<2>& contact)
{
    const MinkowskiDifference<2, ShapeA, ShapeB> difference(a, poseA, b, poseB);
    const double size = difference.size();
    const double squaredDistance = difference.centreToCentre().squaredNorm();
    if (!(squaredDistance <= size * size))
    {
        return std::isfinite(squaredDistance) ? PairStatus::separated : PairStatus::notFinite;
    }
    if (direction == Vector2::Zero())
    {
        direction = difference.centreToCentre() == Vector2::Zero() ? Vector2(Vector2::UnitX()) : difference.centreToCentre();
    }

    const GjkResult<2> search = gjk<2>(difference, direction);
    if (search.status == GjkStatus::notFinite)
    {
        return PairStatus::notFinite;
    }
    if (search.status == GjkStatus::iterationLimit)
    {
        return PairStatus::undecided;
    }
    if (search.status != GjkStatus::overlapping)
    {
        direction = search.direction;
        return PairStatus::separated;
    }
    const EpaResult<2> penetration = epa<2>(difference, search.simplex);
    contact.depth = penetration.depth;
    contact.normal = penetration.normal;
    contact.point = poseA.position + penetration.point;
    direction = penetration.normal;
    if (!(penetration.depth > 0))
    {
        return PairStatus::separated;
    }
    return penetration.status == EpaStatus::converged ? PairStatus::overlapping : PairStatus::coarse;
}

} // namespace

PairStatus pairContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    Vector2& direction,
    ContactGeometry<2>& contact)
{
    return std::visit(
        [&](const auto& shapeA, const auto& shapeB) { return contactOf(shapeA, poseA, shapeB, poseB, direction, contact); }, a, b);
}

} // namespace chesil
