#include "core/world/world.hpp"

#include "core/dynamics/localDamping.hpp"
#include "core/dynamics/stableTimeStep.hpp"
#include "core/dynamics/velocityVerlet.hpp"
#include "core/world/flatContact.hpp"
#include "core/world/pairContact.hpp"
#include "core/world/wallContact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

/// Share of the smallest grain's radius that grains may move before neighbours are searched again: the optimum
/// between long lists and frequent searches is flat around it.
constexpr double skinShare = 0.3;

} // namespace

World::World(WorldSettings settings) : settings_(std::move(settings))
{
    for (const NamedShape& named : settings_.shapes)
    {
        masses_.push_back(massProperties(named.shape));
        straightSided_.push_back(hasStraightSides(named.shape));
    }
    double smallest = std::numeric_limits<double>::infinity();
    for (const GrainState& grain : settings_.grains)
    {
        const auto shape = static_cast<std::size_t>(grain.shape);
        const double radius = boundingRadius(settings_.shapes[shape].shape);
        const double mass = settings_.density * masses_[shape].area;
        const double inertia = settings_.density * masses_[shape].polarMoment;
        bodies_.pose.push_back({grain.position, Rotation<2>(grain.angle)});
        bodies_.velocity.push_back(grain.velocity);
        bodies_.angularVelocity.push_back(grain.angularVelocity);
        bodies_.inverseMass.push_back(grain.driven ? 0 : 1 / mass);
        bodies_.inverseInertia.push_back(grain.driven ? 0 : 1 / inertia);
        bodies_.shape.push_back(grain.shape);
        bodies_.boundingRadius.push_back(radius);
        halfExtents_.emplace_back(radius, radius);
        weights_.push_back(mass * settings_.gravity);
        smallest = std::min(smallest, radius);
    }
    bodies_.force.assign(bodies_.size(), Vector2::Zero());
    bodies_.torque.assign(bodies_.size(), 0.0);
    skin_ = bodies_.size() > 0 ? skinShare * smallest : 0;
}

void World::immerse(double fluidDensity, double virtualMass)
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        weights_[i] = (settings_.density - fluidDensity) * areaOf(i) * settings_.gravity;
        if (bodies_.inverseMass[i] > 0)
        {
            const double density = settings_.density + virtualMass * fluidDensity;
            bodies_.inverseMass[i] = 1 / (density * areaOf(i));
            bodies_.inverseInertia[i] = 1 / (density * polarMomentOf(i));
        }
    }
}

void World::setExternalLoads(const std::vector<Vector2>& forces, const std::vector<double>& torques)
{
    externalForces_ = forces;
    externalTorques_ = torques;
}

double World::sizeOf(std::size_t grain) const
{
    return 2 * std::sqrt(areaOf(grain) / M_PI);
}

double World::stableTimeStep() const
{
    const double stiffness = std::max(settings_.contact.normalStiffness, settings_.contact.tangentialStiffness);
    StableTimeStep step;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (bodies_.inverseMass[i] > 0)
        {
            const int places = isStraightSided(i) ? 2 : 1;
            step.add(1 / bodies_.inverseMass[i], 1 / bodies_.inverseInertia[i], bodies_.boundingRadius[i], places);
        }
    }
    return step.of(stiffness, settings_.contact.dampingRatio, settings_.localDamping);
}

StepStatus World::step(double timeStep)
{
    kick(bodies_, timeStep / 2);
    drift(bodies_, timeStep);
    updateForces(timeStep);
    kick(bodies_, timeStep / 2);
    return checkFinite();
}

void World::updateForces(double timeStep)
{
    updateNeighbours();
    applyWeights();
    for (std::size_t i = 0; i < contacts_.size(); i += placesOf(i))
    {
        resolve(i, timeStep);
    }
    if (settings_.localDamping > 0)
    {
        dampLocally(bodies_, settings_.localDamping);
    }
}

bool World::neighboursAreStale() const
{
    if (positionsAtSearch_.size() != bodies_.size())
    {
        return true;
    }
    const double most = skin_ / 2;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        // Written so that a position that is not a number asks for a search, too.
        if (!((bodies_.pose[i].position - positionsAtSearch_[i]).squaredNorm() <= most * most))
        {
            return true;
        }
    }
    return false;
}

void World::updateNeighbours()
{
    if (bodies_.size() > 0 && neighboursAreStale())
    {
        positionsAtSearch_.resize(bodies_.size());
        std::transform(
            bodies_.pose.begin(), bodies_.pose.end(), positionsAtSearch_.begin(), [](const Pose<2>& p) { return p.position; });
        findContacts();
    }
}

void World::addPair(std::int32_t first, std::int32_t second, bool flat)
{
    contacts_.push_back({first, second});
    if (flat)
    {
        contacts_.push_back({first, second, 1});
    }
}

std::size_t World::placesOf(std::size_t contact) const
{
    return contact + 1 < contacts_.size() && contacts_[contact + 1].place == 1 ? 2 : 1;
}

void World::findContacts()
{
    std::swap(contacts_, lastContacts_);
    contacts_.clear();
    for (const auto& [first, second] : search_.find(positionsAtSearch_, halfExtents_, bodies_.boundingRadius, skin_))
    {
        const bool flat = isStraightSided(static_cast<std::size_t>(first)) && isStraightSided(static_cast<std::size_t>(second));
        addPair(first, second, flat);
    }
    const auto firstWallContact = contacts_.size();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        for (std::size_t w = settings_.walls.size(); w-- > 0;)
        {
            if (settings_.walls[w].distance(positionsAtSearch_[i]) <= bodies_.boundingRadius[i] + skin_)
            {
                addPair(static_cast<std::int32_t>(i), Contact<2>::wallAsSecond(w), isStraightSided(i));
            }
        }
    }

    // What pairs remember goes along. Both lists are sorted by key within grains and within walls.
    const auto carry = [](auto begin, auto end, auto oldBegin, auto oldEnd)
    {
        for (auto old = oldBegin; begin != end && old != oldEnd;)
        {
            if (begin->key() == old->key())
            {
                *begin++ = *old++;
            }
            else if (begin->key() < old->key())
            {
                ++begin;
            }
            else
            {
                ++old;
            }
        }
    };
    const auto isWall = [](const Contact<2>& contact) { return contact.withWall(); };
    const auto wallBegin = contacts_.begin() + static_cast<std::ptrdiff_t>(firstWallContact);
    const auto oldWallBegin = std::find_if(lastContacts_.begin(), lastContacts_.end(), isWall);
    carry(contacts_.begin(), wallBegin, lastContacts_.begin(), oldWallBegin);
    carry(wallBegin, contacts_.end(), oldWallBegin, lastContacts_.end());
}

void World::applyWeights()
{
    const bool loaded = !externalForces_.empty();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        bodies_.force[i] = loaded ? Vector2(weights_[i] + externalForces_[i]) : weights_[i];
        bodies_.torque[i] = loaded ? externalTorques_[i] : 0;
    }
}

void World::resolve(std::size_t index, double timeStep)
{
    Contact<2>& contact = contacts_[index];
    Contact<2>* second = placesOf(index) == 2 ? &contacts_[index + 1] : nullptr;
    ContactGeometry<2> found;
    if (!(contact.withWall() ? touchesWall(contact, found) : touchesGrain(contact, found)))
    {
        release(contact);
        if (second)
        {
            release(*second);
        }
        return;
    }
    contact.normal = found.normal;
    std::array<ContactGeometry<2>, 2> places;
    if (second && areFlat(contact, found, places))
    {
        // The one corner of a tilted side is the same contact, whichever end of the other shape it is.
        const bool first = contact.depth > 0;
        if (first != (second->depth > 0) && !(places[first ? 0 : 1].depth > 0))
        {
            std::swap(contact.spring, second->spring);
        }
        load(contact, places[0], timeStep);
        load(*second, places[1], timeStep);
        return;
    }
    load(contact, found, timeStep);
    if (second)
    {
        release(*second);
    }
}

void World::load(Contact<2>& contact, const ContactGeometry<2>& geometry, double timeStep)
{
    if (!(geometry.depth > 0))
    {
        release(contact);
        return;
    }
    contact.depth = geometry.depth;
    contact.normal = geometry.normal;
    contact.point = geometry.point;
    loadBodies(contact, timeStep);
}

void World::release(Contact<2>& contact)
{
    contact.depth = 0;
    contact.spring = Vector2::Zero();
    contact.force = Vector2::Zero();
}

bool World::areFlat(const Contact<2>& contact, const ContactGeometry<2>& found, std::array<ContactGeometry<2>, 2>& places) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    if (contact.withWall())
    {
        return flatContact(shapeOf(i), bodies_.pose[i], settings_.walls[contact.wall()], found, places);
    }
    const auto j = static_cast<std::size_t>(contact.second);
    return flatContact(shapeOf(i), bodies_.pose[i], shapeOf(j), bodies_.pose[j], found, places);
}

bool World::touchesGrain(Contact<2>& contact, ContactGeometry<2>& found)
{
    const PairStatus status = queryGrains(contact, found);
    if (status == PairStatus::undecided || status == PairStatus::coarse)
    {
        ++doubtfulQueries_;
    }
    return status == PairStatus::overlapping || status == PairStatus::coarse;
}

PairStatus World::queryGrains(Contact<2>& contact, ContactGeometry<2>& found)
{
    const auto i = static_cast<std::size_t>(contact.first);
    const auto j = static_cast<std::size_t>(contact.second);
    SearchStart start{contact.normal, contact.turn};
    QueryCost cost;
    const PairStatus status = settings_.contactStatistics
        ? pairContact(shapeOf(i), bodies_.pose[i], shapeOf(j), bodies_.pose[j], start, found, cost)
        : pairContact(shapeOf(i), bodies_.pose[i], shapeOf(j), bodies_.pose[j], start, found);
    contact.normal = start.direction;
    contact.turn = start.turn;
    if (!settings_.contactStatistics)
    {
        return status;
    }
    ++contactStatistics_.queries;
    contactStatistics_.contacts += status == PairStatus::overlapping || status == PairStatus::coarse;
    contactStatistics_.supportCalls += static_cast<std::size_t>(cost.supportCalls);
    contactStatistics_.sweeps += cost.swept;
    return status;
}

bool World::touchesWall(const Contact<2>& contact, ContactGeometry<2>& found) const
{
    const auto i = static_cast<std::size_t>(contact.first);
    const PlaneWall<2>& wall = settings_.walls[contact.wall()];
    const Pose<2>& pose = bodies_.pose[i];
    return wall.distance(pose.position) <= bodies_.boundingRadius[i] && wallContact(shapeOf(i), pose, wall, found);
}

void World::loadBodies(Contact<2>& contact, double timeStep)
{
    const auto i = static_cast<std::size_t>(contact.first);
    const Vector2 armI = contact.point - bodies_.pose[i].position;
    const Vector2 velocityI = bodies_.velocity[i] + velocityAt(bodies_.angularVelocity[i], armI);
    double inverseMass = bodies_.inverseMass[i];
    Vector2 relative = velocityI;
    Vector2 armJ = Vector2::Zero();
    if (!contact.withWall())
    {
        const auto j = static_cast<std::size_t>(contact.second);
        armJ = contact.point - bodies_.pose[j].position;
        relative -= bodies_.velocity[j] + velocityAt(bodies_.angularVelocity[j], armJ);
        inverseMass += bodies_.inverseMass[j];
    }
    // Two driven bodies feel no force; any mass does.
    const double effectiveMass = inverseMass > 0 ? 1 / inverseMass : 0;
    const ContactState<2> state{contact.depth, contact.normal, relative, effectiveMass};
    contact.force = contactForce(settings_.contact, state, timeStep, contact.spring);

    bodies_.force[i] += contact.force;
    bodies_.torque[i] += torqueOf(armI, contact.force);
    if (!contact.withWall())
    {
        const auto j = static_cast<std::size_t>(contact.second);
        bodies_.force[j] -= contact.force;
        bodies_.torque[j] -= torqueOf(armJ, contact.force);
    }
}

StepStatus World::checkFinite()
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (!bodies_.velocity[i].allFinite() || !std::isfinite(bodies_.angularVelocity[i])
            || !bodies_.pose[i].position.allFinite())
        {
            brokenGrain_ = i;
            return StepStatus::notFinite;
        }
    }
    return StepStatus::done;
}

double World::largestRelativeOverlap() const
{
    double largest = 0;
    for (const Contact<2>& contact : contacts_)
    {
        double size = sizeOf(static_cast<std::size_t>(contact.first));
        if (!contact.withWall())
        {
            size = std::min(size, sizeOf(static_cast<std::size_t>(contact.second)));
        }
        largest = std::max(largest, contact.depth / size);
    }
    return largest;
}

} // namespace chesil
