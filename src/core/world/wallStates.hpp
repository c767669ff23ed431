#pragma once

#include "core/boundary/planeWall.hpp"
#include "core/contact/contactState.hpp"

#include <vector>

namespace chesil
{

/// What a wall does and feels in the present step. World frame.
struct WallState
{
    /// [m/s].
    Vector2 velocity = Vector2::Zero();
    /// Of the grains on the wall [N].
    Vector2 force = Vector2::Zero();
    /// Sums of its contacts' normal stiffness [N/m] and damping [N s/m].
    double stiffness = 0;
    double damping = 0;
    /// That the wall has done on the grains since the start [J].
    double work = 0;
};

/// The walls as they are, and their motion.
class WallStates
{
public:
    explicit WallStates(const std::vector<PlaneWall<2>>& walls);

    const std::vector<PlaneWall<2>>& walls() const { return walls_; }
    const std::vector<WallState>& states() const { return states_; }

    /// Of a plate, else 0 [m].
    double halfThickness(std::size_t wall) const { return halfThickness_[wall]; }

    /// False if none ever moves: then nothing below is needed but the forces.
    bool anyMoves() const { return anyMoves_; }

    /// Sets this step's velocities from the law of motion, or the last step's forces.
    void setVelocities(double time, double timeStep);

    /// Moves the walls.
    void drift(double timeStep);

    void clearForces();

    /// `force` on the wall [N].
    void add(std::size_t wall, const Vector2& force) { states_[wall].force += force; }

    /// Of a contact [N/m, N s/m].
    void noteContact(std::size_t wall, double normalStiffness, double damping)
    {
        states_[wall].stiffness += normalStiffness;
        states_[wall].damping += damping;
    }

    /// Half a step's work of the present forces at the present velocities, or what is to come of it.
    void addWork(double interval);

    /// That all walls have done since the start [J].
    double work() const;

    /// Farthest that a wall has come from where it was at noteSearch(), if it does not end along its normal [m].
    double movedSinceSearch() const;
    void noteSearch();

    const std::vector<Vector2>& pointsAtSearch() const { return pointsAtSearch_; }
    void resume(const std::vector<Vector2>& points, const std::vector<Vector2>& pointsAtSearch, std::vector<WallState> states);

    /// Distance between the two walls that bound a servo wall, along it [m].
    double pressedLength(std::size_t wall) const;

private:
    std::vector<PlaneWall<2>> walls_;
    std::vector<WallState> states_;
    std::vector<Vector2> pointsAtSearch_;
    std::vector<double> halfThickness_;
    bool anyMoves_;
};

} // namespace chesil
