#pragma once

#include "core/boundary/planeWall.hpp"
#include "core/boundary/strainedCell.hpp"
#include "core/contact/contactLaws.hpp"
#include "core/shapes/shape.hpp"

#include <optional>
#include <string>
#include <vector>

namespace chesil
{

/// One grain at the start. World frame.
struct GrainState
{
    int shape = 0;
    /// Centroid [m], angle [rad], velocity [m/s], angular velocity [rad/s].
    Vector2 position = Vector2::Zero();
    double angle = 0;
    Vector2 velocity = Vector2::Zero();
    double angularVelocity = 0;
    /// Keeps its velocity whatever the forces.
    bool driven = false;
    /// Index of its material.
    int material = 0;
};

struct Material
{
    std::string name;
    /// [kg/m3]; 2D grains are 1 m deep.
    double density = 0;
};

/// All that a world is made from.
struct WorldSettings
{
    std::vector<NamedShape> shapes;
    std::vector<GrainState> grains;
    std::vector<PlaneWall<2>> walls;
    /// The grains' velocities are on top of its flow then. Wider than two of the biggest grains, NeighbourSearch::find.
    std::optional<StrainedCell> cell;
    /// At least one; the contact law's tables have as many.
    std::vector<Material> materials = std::vector<Material>(1);
    Vector2 gravity = Vector2::Zero();
    ContactLaws contact;
    /// Share of local non-viscous damping, 0 <= share < 1.
    double localDamping = 0;
    /// Drag over momentum, >= 0 [1/s].
    double viscousDamping = 0;
    /// Count what contact queries cost: World::contactStatistics().
    bool contactStatistics = false;
    /// Keep World::energyLedger().
    bool energyLedger = false;

    /// Of a scene with one material and linear contacts.
    LinearLaw& linear() { return std::get<LawTable<LinearLaw>>(contact).only(); }
};

} // namespace chesil
