#include "core/world/flatContact.hpp"

#include "core/base/tolerances.hpp"
#include "core/narrowphase/flatPlaces.hpp"

#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

/// Null for shapes that have none.
const StraightSide* sideFacing(const Shape& shape, const Vector2& normal)
{
    return std::visit(
        [&](const auto& actual) -> const StraightSide*
        {
            if constexpr (OffersCurvature<std::decay_t<decltype(actual)>>::value)
            {
                if constexpr (std::decay_t<decltype(actual)>::mayHaveStraightSides)
                {
                    return actual.straightSideFacing(normal);
                }
            }
            return nullptr;
        },
        shape);
}

/// In the order of the contact's normal, which is opposite to the reference's if `flipped`. Places are found relative to
/// `origin` [m].
void fill(
    const std::array<FlatPlace, 2>& found, bool flipped, const Vector2& origin, std::array<FlatGeometry, 2>& places)
{
    const double sharing = found[0].depth > 0 && found[1].depth > 0 ? found[0].weight + found[1].weight : 1;
    const double sign = flipped ? -1 : 1;
    for (std::size_t i = 0; i < 2; ++i)
    {
        const FlatPlace& place = found[flipped ? 1 - i : i];
        places[i] = {
            {place.depth, flipped ? Vector2(-place.normal) : place.normal, origin + place.point},
            {sharing, place.weight, sign * place.depthPerWay, sign * place.depthPerTurn}};
    }
}

} // namespace

bool hasStraightSides(const Shape& shape)
{
    return sideFacing(shape, Vector2::UnitX()) != nullptr;
}

bool flatContact(
    const Shape& a,
    const Pose<2>& poseA,
    const Shape& b,
    const Pose<2>& poseB,
    const ContactGeometry<2>& contact,
    std::array<FlatGeometry, 2>& places)
{
    const StraightSide* sideA = sideFacing(a, poseA.rotation.applyInverse(contact.normal));
    const StraightSide* sideB = sideFacing(b, poseB.rotation.applyInverse(-contact.normal));
    if (!sideA || !sideB)
    {
        return false;
    }
    const Vector2 normalA = poseA.rotation.apply(sideA->normal);
    const Vector2 normalB = poseB.rotation.apply(sideB->normal);
    const double offA = std::abs(cross(normalA, contact.normal));
    const double offB = std::abs(cross(normalB, contact.normal));
    if (std::min(offA, offB) > tolerances::normalOfSide)
    {
        return false;
    }
    const bool ofA = offA <= offB;
    const StraightSide& reference = ofA ? *sideA : *sideB;
    const StraightSide& incident = ofA ? *sideB : *sideA;
    const Vector2& outward = ofA ? normalA : normalB;
    // Relative to the reference's centroid, so that a scene far from the origin loses no digits.
    const Pose<2>& pose = ofA ? poseA : poseB;
    const Pose<2>& incidentPose = ofA ? poseB : poseA;
    const Pose<2> offset{incidentPose.position - pose.position, incidentPose.rotation};
    const Vector2 deepest = offset.toWorld(support(ofA ? b : a, offset.rotation.applyInverse(-outward)));
    const ReferenceSide side{pose.rotation.apply(reference.start), outward, 0, (reference.end - reference.start).norm()};
    const StraightSide opposite{ofA ? normalB : normalA, offset.toWorld(incident.start), offset.toWorld(incident.end)};
    fill(flatPlaces(side, opposite, deepest), !ofA, pose.position, places);
    return true;
}

bool flatContact(
    const Shape& shape,
    const Pose<2>& pose,
    const PlaneWall<2>& wall,
    const ContactGeometry<2>& contact,
    std::array<FlatGeometry, 2>& places)
{
    if (wall.plate)
    {
        return flatContact(shape, pose, wall.plate->outline, wall.pose(), contact, places);
    }
    const StraightSide* facing = sideFacing(shape, pose.rotation.applyInverse(contact.normal));
    if (!facing)
    {
        return false;
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vector2 deepest = contact.point - contact.depth / 2 * wall.normal;
    const ReferenceSide side{contact.point + contact.depth / 2 * wall.normal, wall.normal, -infinity, infinity};
    const StraightSide opposite{
        pose.rotation.apply(facing->normal), pose.toWorld(facing->start), pose.toWorld(facing->end)};
    fill(flatPlaces(side, opposite, deepest), true, Vector2::Zero(), places);
    return true;
}

} // namespace chesil
