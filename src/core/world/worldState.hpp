#pragma once

#include "core/contact/contact.hpp"
#include "core/measure/energyLedger.hpp"
#include "core/world/wallStates.hpp"

#include <optional>
#include <vector>

namespace chesil
{

/// All that a world carries from one step to the next, beside its settings: with the same settings it goes on
/// to the bit. Arrays as in Bodies, World and WallStates.
struct WorldState
{
    double time = 0;
    std::vector<Vector2> position;
    std::vector<double> angle;
    /// Rotation::direction.
    std::vector<Vector2> direction;
    std::vector<Vector2> velocity;
    std::vector<double> angularVelocity;
    std::vector<Vector2> force;
    std::vector<double> torque;
    /// What the grains are told by: the world that goes on must have the same.
    std::vector<double> inverseMass;
    std::vector<double> inverseInertia;
    std::vector<Vector2> positionsAtSearch;
    /// Empty without slender grains.
    std::vector<double> anglesAtSearch;
    std::vector<Contact<2>> contacts;
    /// Empty without friction; without rolling resistance.
    std::vector<double> springs;
    std::vector<double> turns;
    /// Empty unless the law uses curvature.
    std::vector<double> radii;
    std::vector<Vector2> wallPoints;
    std::vector<Vector2> wallPointsAtSearch;
    std::vector<WallState> wallStates;
    /// With a periodic cell: its lattice vectors now and at the last search [m], and its velocity gradient by rows.
    std::vector<Vector2> cell;
    std::optional<EnergyLedger> ledger;
};

} // namespace chesil
