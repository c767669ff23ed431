#include "core/world/worldState.hpp"

#include "core/base/setupError.hpp"
#include "core/world/world.hpp"

#include <algorithm>

namespace chesil
{

namespace
{

void requireSame(const std::string& what, std::size_t found, std::size_t expected)
{
    if (found != expected)
    {
        throw ValueError(std::to_string(found) + " " + what, std::to_string(expected) + ", as the case has");
    }
}

void requireSameGrains(const std::vector<double>& found, const std::vector<double>& expected)
{
    const auto differ = std::mismatch(found.begin(), found.end(), expected.begin(), expected.end());
    if (differ.first != found.end() || differ.second != expected.end())
    {
        throw ValueError(
            "grain " + std::to_string(differ.first - found.begin()) + " of another mass or inertia",
            "the grains that the state is of");
    }
}

} // namespace

WorldState World::state() const
{
    WorldState state;
    state.time = time_;
    for (const Pose<2>& pose : bodies_.pose)
    {
        state.position.push_back(pose.position);
        state.angle.push_back(pose.rotation.angle());
        state.direction.push_back(pose.rotation.direction());
    }
    state.velocity = bodies_.velocity;
    state.angularVelocity = bodies_.angularVelocity;
    state.force = bodies_.force;
    state.torque = bodies_.torque;
    state.inverseMass = bodies_.inverseMass;
    state.inverseInertia = bodies_.inverseInertia;
    state.positionsAtSearch = positionsAtSearch_;
    state.anglesAtSearch = anglesAtSearch_;
    state.contacts = list_.contacts();
    state.springs = list_.springs();
    state.turns = list_.turns();
    state.radii = list_.radii();
    for (const PlaneWall<2>& wall : walls())
    {
        state.wallPoints.push_back(wall.point);
    }
    state.wallPointsAtSearch = walls_.pointsAtSearch();
    state.wallStates = walls_.states();
    if (cell_)
    {
        const Eigen::Matrix2d& gradient = cell_->velocityGradient;
        state.cell = {cell_->cell.first(), cell_->cell.second(), firstAtSearch_, secondAtSearch_, gradient.row(0), gradient.row(1)};
    }
    state.ledger = ledger_;
    return state;
}

void World::resume(WorldState state)
{
    requireSame("grains", state.position.size(), bodies_.size());
    for (const std::size_t found : {state.angle.size(), state.direction.size(), state.velocity.size(), state.angularVelocity.size(), state.force.size(), state.torque.size()})
    {
        requireSame("entries of a grain's quantity", found, bodies_.size());
    }
    for (const std::size_t found : {state.wallPoints.size(), state.wallPointsAtSearch.size(), state.wallStates.size()})
    {
        requireSame("walls", found, walls().size());
    }
    if (!state.anglesAtSearch.empty())
    {
        requireSame("angles at the last search", state.anglesAtSearch.size(), bodies_.size());
    }
    requireSame("vectors of a periodic cell", state.cell.size(), cell_ ? 6 : 0);
    requireSameGrains(state.inverseMass, bodies_.inverseMass);
    requireSameGrains(state.inverseInertia, bodies_.inverseInertia);
    time_ = state.time;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        bodies_.pose[i] = {state.position[i], Rotation<2>(state.angle[i], state.direction[i])};
    }
    bodies_.velocity = std::move(state.velocity);
    bodies_.angularVelocity = std::move(state.angularVelocity);
    bodies_.force = std::move(state.force);
    bodies_.torque = std::move(state.torque);
    positionsAtSearch_ = std::move(state.positionsAtSearch);
    anglesAtSearch_ = std::move(state.anglesAtSearch);
    list_.resume(std::move(state.contacts), std::move(state.springs), std::move(state.turns), std::move(state.radii));
    walls_.resume(state.wallPoints, state.wallPointsAtSearch, std::move(state.wallStates));
    if (cell_)
    {
        Eigen::Matrix2d gradient;
        gradient << state.cell[4].transpose(), state.cell[5].transpose();
        cell_.emplace(PeriodicCell(cell_->cell.lower(), state.cell[0], state.cell[1]), gradient);
        firstAtSearch_ = state.cell[2];
        secondAtSearch_ = state.cell[3];
        if (cell_->isStrained())
        {
            noteStrain();
        }
    }
    ledger_ = settings_.energyLedger ? state.ledger : std::nullopt;
}

} // namespace chesil
