#include "core/world/world.hpp"

#include "core/dynamics/mostTravel.hpp"
#include "core/world/diskContact.hpp"
#include "core/world/flatContact.hpp"
#include "core/world/wallContact.hpp"

#include <algorithm>

namespace chesil
{

bool World::areFlat(const Contact<2>& contact, const ContactGeometry<2>& found, std::array<FlatGeometry, 2>& places) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    if (contact.withWall())
    {
        return flatContact(shapeOf(i), bodies_.pose[i], walls()[contact.wall()], found, places);
    }
    const auto j = static_cast<std::size_t>(contact.second);
    return flatContact(shapeOf(i), bodies_.pose[i], shapeOf(j), imageOfSecond(contact), found, places);
}

Pose<2> World::imageOfSecond(const Contact<2>& contact) const
{
    Pose<2> image = bodies_.pose[static_cast<std::size_t>(contact.second)];
    if (cell_)
    {
        image.position += offsetOf(contact);
    }
    return image;
}

bool World::touchesGrain(Contact<2>& contact, ContactGeometry<2>& found)
{
    const auto i = static_cast<std::size_t>(contact.first);
    const auto j = static_cast<std::size_t>(contact.second);
    contactStatistics_.queries += settings_.contactStatistics;
    const Vector2& position = bodies_.pose[i].position;
    Vector2 between = bodies_.pose[j].position - position;
    if (cell_)
    {
        between += offsetOf(contact);
    }
    const double reach = bodies_.boundingRadius[i] + bodies_.boundingRadius[j];
    if (!(between.squaredNorm() <= reach * reach))
    {
        return false;
    }
    // Disks are so cheap that the way to the query of any two shapes would show.
    const Circle* diskI = std::get_if<Circle>(&shapeOf(i));
    const Circle* diskJ = std::get_if<Circle>(&shapeOf(j));
    if (diskI && diskJ)
    {
        const bool touches = diskContact(position, between, diskI->radius(), diskJ->radius(), found);
        contactStatistics_.contacts += settings_.contactStatistics && touches;
        return touches;
    }
    const PairStatus status = queryGrains(contact, imageOfSecond(contact), found);
    if (status == PairStatus::undecided || status == PairStatus::coarse)
    {
        ++doubtfulQueries_;
    }
    return status == PairStatus::overlapping || status == PairStatus::coarse;
}

PairStatus World::queryGrains(Contact<2>& contact, const Pose<2>& poseJ, ContactGeometry<2>& found)
{
    const auto i = static_cast<std::size_t>(contact.first);
    const auto j = static_cast<std::size_t>(contact.second);
    SearchStart start{contact.normal, contact.turn, contact.pieces};
    PairStatus status;
    if (settings_.contactStatistics)
    {
        QueryCost cost;
        status = pairContact(shapeOf(i), bodies_.pose[i], shapeOf(j), poseJ, start, found, cost);
        contactStatistics_.contacts += status == PairStatus::overlapping || status == PairStatus::coarse;
        contactStatistics_.supportCalls += static_cast<std::size_t>(cost.supportCalls);
        contactStatistics_.sweeps += cost.swept;
    }
    else
    {
        status = pairContact(shapeOf(i), bodies_.pose[i], shapeOf(j), poseJ, start, found);
    }
    contact.normal = start.direction;
    contact.turn = static_cast<float>(start.turn);
    contact.pieces = start.pieces;
    return status;
}

bool World::touchesWall(Contact<2>& contact, ContactGeometry<2>& found) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    const PlaneWall<2>& wall = walls()[contact.wall()];
    const Pose<2>& pose = bodies_.pose[i];
    if (!(nearestTo(wall, pose.position) <= bodies_.boundingRadius[i] + walls_.halfThickness(contact.wall())))
    {
        return false;
    }
    SearchStart start{contact.normal, contact.turn, contact.pieces};
    const bool touches = wallContact(shapeOf(i), pose, wall, start, found);
    contact.normal = start.direction;
    contact.turn = static_cast<float>(start.turn);
    contact.pieces = start.pieces;
    return touches;
}

double World::effectiveRadius(const Contact<2>& contact) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    const double radius = curvatureRadius(shapeOf(i), bodies_.pose[i].rotation.applyInverse(contact.normal));
    if (contact.withWall())
    {
        return radius;
    }
    const auto j = static_cast<std::size_t>(contact.second);
    const double other = curvatureRadius(shapeOf(j), bodies_.pose[j].rotation.applyInverse(-contact.normal));
    return radius * (other / (radius + other));
}

double World::rollingRadius(const Contact<2>& contact) const
{
    const double radius = sizeOf(static_cast<std::size_t>(contact.first)) / 2;
    if (contact.withWall())
    {
        return radius;
    }
    const double other = sizeOf(static_cast<std::size_t>(contact.second)) / 2;
    return radius * other / (radius + other);
}

/// A contact that grows too deep is about to pass through; one that was made so deep may relax.
void World::noteDepth(const Contact<2>& contact, double way)
{
    double radii = innerRadiusOf(static_cast<std::size_t>(contact.first));
    if (!contact.withWall())
    {
        radii += innerRadiusOf(static_cast<std::size_t>(contact.second));
    }
    const bool endless = contact.withWall() && !walls()[contact.wall()].plate;
    if (contact.depth > mostDepth(radii, way) && !endless && !tooDeep_)
    {
        tooDeep_ = true;
        brokenGrain_ = static_cast<std::size_t>(contact.first);
    }
}

void World::noteStiffness(std::size_t i, std::size_t j, const ContactSprings& springs)
{
    const auto bound = [this](std::size_t grain) { return stiffness_[static_cast<std::size_t>(bodies_.shape[grain])]; };
    if (std::max(springs.normalStiffness, springs.tangentialStiffness) > std::min(bound(i), bound(j)) && !tooDeep_)
    {
        tooDeep_ = true;
        brokenGrain_ = i;
    }
}

} // namespace chesil
