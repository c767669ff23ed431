#include "core/world/world.hpp"

#include "core/contact/contactForce.hpp"
#include "core/contact/rollingResistance.hpp"
#include "core/world/diskContact.hpp"

#include <utility>

namespace chesil
{

void World::resolveContacts(double timeStep)
{
    const auto resolveWith = [&](const auto& laws)
    { cell_ ? resolveAll<true>(laws, timeStep) : resolveAll<false>(laws, timeStep); };
    std::visit(resolveWith, settings_.contact);
}

template <bool periodic, class Law>
void World::resolveAll(const LawTable<Law>& laws, double timeStep)
{
    const std::size_t entries = list_.contacts().size();
    for (std::size_t i = onlyDisks_ ? resolveDisks<periodic>(laws, timeStep) : 0; i < entries; i += list_.placesOf(i))
    {
        resolve<periodic>(laws, i, timeStep);
    }
}

/// What resolve() does for pairs of grains, which come first, without what disks have no need of: they are so cheap that it
/// would show. Returns the first entry with a wall.
template <bool periodic, class Law>
std::size_t World::resolveDisks(const LawTable<Law>& laws, double timeStep)
{
    Contact<2>* const contacts = list_.contacts().data();
    const std::size_t entries = list_.contacts().size();
    const Pose<2>* const poses = bodies_.pose.data();
    const double* const radii = bodies_.boundingRadius.data();
    std::size_t touching = 0;
    std::size_t index = 0;
    for (; index < entries && !contacts[index].withWall(); ++index)
    {
        const Contact<2>& contact = contacts[index];
        const auto i = static_cast<std::size_t>(contact.first);
        const auto j = static_cast<std::size_t>(contact.second);
        const Vector2& position = poses[i].position;
        Vector2 between = poses[j].position - position;
        if (periodic && contact.withImage())
        {
            between += offsetOf(contact);
        }
        ContactGeometry<2> found;
        if (diskContact(position, between, radii[i], radii[j], found))
        {
            ++touching;
            load<periodic>(lawOf(laws, contact), index, found, timeStep);
        }
        else if (contact.depth > 0)
        {
            release(lawOf(laws, contact), index);
        }
    }
    if (settings_.contactStatistics)
    {
        contactStatistics_.queries += index;
        contactStatistics_.contacts += touching;
    }
    return index;
}

template <bool periodic, class Law>
void World::resolve(const LawTable<Law>& laws, std::size_t index, double timeStep)
{
    Contact<2>& contact = list_.contacts()[index];
    Contact<2>* second = list_.placesOf(index) == 2 ? &contact + 1 : nullptr;
    const Law& law = lawOf(laws, contact);
    const auto deeper = [&]() -> Contact<2>& { return second && second->depth > contact.depth ? *second : contact; };
    const SideHeld<2> before{deeper().depth, deeper().normal};
    ContactGeometry<2> found;
    if (!(contact.withWall() ? touchesWall(contact, found) : touchesGrain(contact, found)))
    {
        release(law, index);
        if (second)
        {
            release(law, index + 1);
        }
        return;
    }
    contact.normal = found.normal;
    std::array<FlatGeometry, 2> places;
    if (second && areFlat(contact, found, places))
    {
        // The one corner of a tilted side is the same contact, whichever end of the other shape it is.
        const bool first = contact.depth > 0;
        double* spring = list_.springOf(index);
        if (spring && first != (second->depth > 0) && !(places[first ? 0 : 1].depth > 0))
        {
            std::swap(*spring, *list_.springOf(index + 1));
        }
        // Each place damps half of the mass, if there are two: together they give the restitution that was asked.
        for (std::size_t i = 0; i < 2; ++i)
        {
            load<periodic>(law, index + i, places[i], timeStep, places[i].share);
        }
    }
    else
    {
        load<periodic>(law, index, found, timeStep);
        if (second)
        {
            release(law, index + 1);
        }
    }
    noteSideChange<periodic>(deeper(), before, timeStep);
}

template <class Law>
void World::release(const Law& law, std::size_t index)
{
    if (!(contacts()[index].depth > 0))
    {
        return;
    }
    if (ledger_)
    {
        ledger_->contacts += springEnergyOf(law.springs(stateAtRest<Law>(index)), law.rollingFriction, index);
    }
    list_.release(index);
}

template <bool periodic, class Law>
[[gnu::always_inline]] inline void World::load(const Law& law, std::size_t index, const ContactGeometry<2>& geometry, double timeStep, const PlaceShare& share)
{
    if (!(geometry.depth > 0))
    {
        release(law, index);
        return;
    }
    Contact<2>& contact = list_.contacts()[index];
    const double previousDepth = contact.depth;
    contact.depth = geometry.depth;
    contact.normal = geometry.normal;
    contact.point = geometry.point;
    loadBodies<periodic>(law, index, previousDepth, timeStep, share);
}

/// How the first body of a contact moves against the second.
struct World::Meeting
{
    /// From the centroids to the contact point, that of a wall zero [m].
    Vector2 armOfFirst;
    Vector2 armOfSecond = Vector2::Zero();
    /// Of the second one's image against itself [m/s].
    Vector2 imageVelocity = Vector2::Zero();
    /// At the contact point [m/s].
    Vector2 velocity;
    /// [rad/s].
    double spin;
    double inverseMass;
};

template <bool periodic>
[[gnu::always_inline]] inline World::Meeting World::meetingAt(const Contact<2>& contact) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    Meeting meeting;
    meeting.armOfFirst = contact.point - bodies_.pose[i].position;
    meeting.velocity = bodies_.velocity[i] + velocityAt(bodies_.angularVelocity[i], meeting.armOfFirst);
    meeting.spin = bodies_.angularVelocity[i];
    meeting.inverseMass = bodies_.inverseMass[i];
    if (contact.withWall())
    {
        meeting.velocity -= walls_.states()[contact.wall()].velocity;
        return meeting;
    }
    const auto j = static_cast<std::size_t>(contact.second);
    meeting.armOfSecond = contact.point - bodies_.pose[j].position;
    if (periodic && contact.withImage())
    {
        const Vector2 offset = offsetOf(contact);
        meeting.armOfSecond -= offset;
        meeting.imageVelocity = cell_->velocityGradient * offset;
        meeting.velocity -= meeting.imageVelocity;
    }
    meeting.velocity -= bodies_.velocity[j] + velocityAt(bodies_.angularVelocity[j], meeting.armOfSecond);
    meeting.spin -= bodies_.angularVelocity[j];
    meeting.inverseMass += bodies_.inverseMass[j];
    return meeting;
}

/// `force` at the contact point and `couple` [N m], on the first body; the opposite on the other.
template <bool periodic>
[[gnu::always_inline]] inline void World::push(const Contact<2>& contact, const Meeting& meeting, const Vector2& force, double couple, double timeStep)
{
    if constexpr (periodic)
    {
        if (ledger_)
        {
            ledger_->walls += timeStep * force.dot(meeting.imageVelocity);
        }
    }
    const auto i = static_cast<std::size_t>(contact.first);
    bodies_.force[i] += force;
    bodies_.torque[i] += torqueOf(meeting.armOfFirst, force) + couple;
    if (contact.withWall())
    {
        walls_.add(contact.wall(), -force);
        return;
    }
    const auto j = static_cast<std::size_t>(contact.second);
    bodies_.force[j] -= force;
    bodies_.torque[j] -= torqueOf(meeting.armOfSecond, force) + couple;
}

template <bool periodic>
void World::noteSideChange(Contact<2>& contact, const SideHeld<2>& before, double timeStep)
{
    const SideHeld<2> now{contact.depth, contact.normal};
    if (!areOfTwoSides(before, now))
    {
        return;
    }
    const Meeting meeting = meetingAt<periodic>(contact);
    const Vector2 change = sideChange(before, now, meeting.velocity, -contact.force.dot(contact.normal), timeStep);
    contact.force += change;
    push<periodic>(contact, meeting, change, 0, timeStep);
}

template <bool periodic, class Law>
[[gnu::always_inline]] inline void World::loadBodies(const Law& law, std::size_t index, double previousDepth, double timeStep, const PlaceShare& share)
{
    Contact<2>& contact = list_.contacts()[index];
    const bool withWall = contact.withWall();
    const auto i = static_cast<std::size_t>(contact.first);
    const std::size_t j = withWall ? i : static_cast<std::size_t>(contact.second);
    const Meeting meeting = meetingAt<periodic>(contact);
    if (contact.depth > shallow_ && contact.depth > previousDepth)
    {
        noteDepth(contact, timeStep * meeting.velocity.norm());
    }
    const bool fades = share.weight != 1;
    Vector2 rate = meeting.velocity;
    if (fades)
    {
        const double byWeight = meeting.velocity.dot(share.depthPerWay) + meeting.spin * share.depthPerTurn;
        rate = share.weight * meeting.velocity + byWeight * contact.normal;
    }
    const double inverseMass = share.sharing * meeting.inverseMass;
    ContactState<2> state{contact.depth, contact.normal, rate, inverseMass, 0, previousDepth};
    // A place of less weight damps little: there the velocity of the half step before will do.
    if (anticipates_ && !fades)
    {
        state.anticipates = true;
        const Vector2 gain = withWall ? expectedGains_[i] : Vector2(expectedGains_[i] - expectedGains_[j]);
        state.expectedGain = gain.dot(contact.normal);
        state.previousForce = -contact.force.dot(contact.normal);
    }
    if constexpr (Law::usesCurvature)
    {
        // Held while they touch, so that the force has a potential: a radius that changed on the way would make energy.
        double& radius = list_.radiusOf(index);
        radius = previousDepth > 0 && radius > 0 ? radius : effectiveRadius(contact);
        state.effectiveRadius = radius;
    }
    double* loss = ledger_ ? &ledger_->contacts : nullptr;
    const ContactForce<2> result = contactForce(law, state, timeStep, list_.springOf(index), loss);
    if constexpr (Law::usesCurvature)
    {
        noteStiffness(i, j, result.springs);
    }
    contact.force = result.force;
    double couple = 0;
    if (fades)
    {
        const double pull = result.force.dot(contact.normal);
        contact.force = share.weight * result.force + pull * share.depthPerWay;
        couple = pull * share.depthPerTurn;
    }
    push<periodic>(contact, meeting, contact.force, couple, timeStep);
    if (withWall)
    {
        const double square = share.weight * share.weight;
        walls_.noteContact(contact.wall(), square * result.springs.normalStiffness, square * result.damping);
    }
    if (double* turned = list_.turnOf(index); turned && law.rollingFriction > 0)
    {
        const double torque = rollingTorque(
            law.rollingFriction, rollingRadius(contact), share.weight * result.pressing, result.springs.normalStiffness, meeting.spin, timeStep,
            *turned, loss);
        bodies_.torque[i] += torque;
        if (!withWall)
        {
            bodies_.torque[j] -= torque;
        }
    }
}

} // namespace chesil
