#include "core/world/wallContact.hpp"

#include "core/world/pairContact.hpp"

namespace chesil
{

bool wallContact(
    const Shape& shape, const Pose<2>& pose, const PlaneWall<2>& wall, SearchStart& start, ContactGeometry<2>& contact)
{
    if (wall.plate)
    {
        const PairStatus status = pairContact(shape, pose, wall.plate->outline, wall.pose(), start, contact);
        return status == PairStatus::overlapping || status == PairStatus::coarse;
    }
    const Vector2 foot = std::visit([&](const auto& actual) { return footPoint(actual, pose, wall); }, shape);
    const double depth = -wall.distance(foot);
    if (!(depth > 0))
    {
        return false;
    }
    contact.depth = depth;
    contact.normal = -wall.normal;
    contact.point = foot + depth / 2 * wall.normal;
    return true;
}

} // namespace chesil
