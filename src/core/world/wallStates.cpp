#include "core/world/wallStates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace chesil
{

WallStates::WallStates(const std::vector<PlaneWall<2>>& walls)
: walls_(walls),
  states_(walls.size()),
  anyMoves_(std::any_of(walls.begin(), walls.end(), [](const PlaneWall<2>& wall) { return moves(wall.motion); }))
{
    for (const PlaneWall<2>& wall : walls_)
    {
        halfThickness_.push_back(wall.plate ? support(wall.plate->outline, wall.normal).dot(wall.normal) : 0);
    }
    noteSearch();
}

double WallStates::pressedLength(std::size_t wall) const
{
    const ServoWall& servo = std::get<ServoWall>(walls_[wall].motion);
    const Vector2 along = perpendicular(walls_[wall].normal);
    const auto crossing = [&](std::size_t other)
    { return -walls_[other].distance(walls_[wall].point) / along.dot(walls_[other].normal); };
    return std::abs(crossing(servo.between[0]) - crossing(servo.between[1]));
}

void WallStates::setVelocities(double time, double timeStep)
{
    for (std::size_t w = 0; w < walls_.size(); ++w)
    {
        WallState& state = states_[w];
        if (const auto* driven = std::get_if<DrivenWall>(&walls_[w].motion))
        {
            state.velocity = driven->velocityOver(time, timeStep);
        }
        else if (const auto* servo = std::get_if<ServoWall>(&walls_[w].motion))
        {
            const double pressing = -state.force.dot(walls_[w].normal);
            const double wanted = servo->pressure * pressedLength(w);
            state.velocity = servo->speedFor(pressing, wanted, state.stiffness * timeStep + state.damping) * walls_[w].normal;
        }
        else if (const auto* closing = std::get_if<ClosingWall>(&walls_[w].motion))
        {
            const double distance = walls_[w].distance(walls_[closing->opposite].point);
            state.velocity = closing->speedOver(distance, timeStep) * walls_[w].normal;
        }
    }
}

void WallStates::drift(double timeStep)
{
    for (std::size_t w = 0; w < walls_.size(); ++w)
    {
        walls_[w].point += timeStep * states_[w].velocity;
    }
}

void WallStates::clearForces()
{
    for (WallState& state : states_)
    {
        state.force = Vector2::Zero();
        state.stiffness = 0;
        state.damping = 0;
    }
}

void WallStates::addWork(double interval)
{
    for (WallState& state : states_)
    {
        state.work -= interval * state.force.dot(state.velocity);
    }
}

void WallStates::resume(
    const std::vector<Vector2>& points, const std::vector<Vector2>& pointsAtSearch, std::vector<WallState> states)
{
    for (std::size_t w = 0; w < walls_.size(); ++w)
    {
        walls_[w].point = points[w];
    }
    pointsAtSearch_ = pointsAtSearch;
    states_ = std::move(states);
}

double WallStates::work() const
{
    return std::accumulate(
        states_.begin(), states_.end(), 0.0, [](double sum, const WallState& state) { return sum + state.work; });
}

double WallStates::movedSinceSearch() const
{
    double most = 0;
    for (std::size_t w = 0; w < walls_.size(); ++w)
    {
        const Vector2 way = walls_[w].point - pointsAtSearch_[w];
        most = std::max(most, walls_[w].plate ? way.norm() : std::abs(walls_[w].normal.dot(way)));
    }
    return most;
}

void WallStates::noteSearch()
{
    pointsAtSearch_.clear();
    for (const PlaneWall<2>& wall : walls_)
    {
        pointsAtSearch_.push_back(wall.point);
    }
}

} // namespace chesil
