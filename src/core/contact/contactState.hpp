#pragma once

#include "core/base/vector.hpp"

namespace chesil
{

/// What a law needs to know of a contact at one instant, world frame.
template <int Dim>
struct ContactState
{
    double depth;
    /// Unit, from the first body to the second.
    Vector<Dim> normal;
    /// Velocity of the first body less that of the second, at the contact point [m/s].
    Vector<Dim> relativeVelocity;
    /// 1/m1 + 1/m2 [1/kg]; 0: neither moves by forces, and nothing is damped.
    double inverseMass;
    /// 1/(1/r1 + 1/r2) of the radii of curvature [m]; for laws that say usesCurvature.
    double effectiveRadius = 0;
    /// Depth one step ago [m], 0 if there was no contact.
    double previousDepth = 0;
    /// Whether the two below are given, and the dashpot is to work on the velocity at the step's end.
    bool anticipates = false;
    /// Of the approach until the step's end [m/s], if forces stayed those of the step before, this contact's normal one,
    /// repulsive, among them [N].
    double expectedGain = 0;
    double previousForce = 0;
};

/// A contact's elastic part at one instant.
struct ContactSprings
{
    /// Repulsive normal force [N].
    double normalForce;
    /// Its slope, and the stiffness against slip [N/m].
    double normalStiffness;
    double tangentialStiffness;
    /// Tangential stiffness one step ago over that now. While it grows the tangential force keeps its size, while it
    /// falls the spring keeps its length.
    double stiffnessRatio;
};

} // namespace chesil
