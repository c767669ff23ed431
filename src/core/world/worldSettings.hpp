#pragma once

#include "core/boundary/planeWall.hpp"
#include "core/contact/linearLaw.hpp"
#include "core/shapes/shape.hpp"

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
};

/// All that a world is made from.
struct WorldSettings
{
    std::vector<NamedShape> shapes;
    std::vector<GrainState> grains;
    std::vector<PlaneWall<2>> walls;
    /// [kg/m3]; 2D grains are 1 m deep.
    double density = 0;
    Vector2 gravity = Vector2::Zero();
    LinearLaw contact;
    /// Share of local non-viscous damping, 0 <= share < 1.
    double localDamping = 0;
    /// Count what contact queries cost: World::contactStatistics().
    bool contactStatistics = false;
};

} // namespace chesil
