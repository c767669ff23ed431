#pragma once

#include "core/contact/contactState.hpp"

#include <algorithm>

namespace chesil
{

/// Linear springs and dashpots with Coulomb friction (Cundall & Strack 1979). Per unit depth in 2D.
struct LinearLaw
{
    static constexpr const char* typeName = "linear";
    static constexpr bool usesCurvature = false;
    /// Whether the dashpot's coefficient is there from the first touch on; else it grows with the depth.
    static constexpr bool dampsAtOnce = true;
    /// Of the dashpots' coefficient 2 dampingRatio sqrt(mass stiffness).
    static constexpr double dampingFactor = 1;

    /// Normal elastic energy over force times depth.
    static constexpr double energyShare = 0.5;

    /// [N/m] > 0.
    double normalStiffness = 0;
    /// [N/m] >= 0; 0 means no tangential force.
    double tangentialStiffness = 0;
    /// Coulomb coefficient >= 0.
    double friction = 0;
    /// Share of critical damping of the pair's effective mass, >= 0: dampingRatioOf(restitution).
    double dampingRatio = 0;
    /// Attraction of a contact, >= 0 [N].
    double cohesion = 0;
    /// Rolling torque over the normal force and the rolling radius, >= 0: rollingResistance.hpp.
    double rollingFriction = 0;

    bool frictional() const { return friction > 0 && tangentialStiffness > 0; }

    /// Largest stiffness, either way, of contacts between grains of this radius of curvature [m].
    double largestStiffness(double) const { return std::max(normalStiffness, tangentialStiffness); }

    /// What draws the two bodies together while they touch [N].
    template <int Dim>
    double attraction(const ContactState<Dim>&) const
    {
        return cohesion;
    }

    template <int Dim>
    ContactSprings springs(const ContactState<Dim>& contact) const
    {
        return {normalStiffness * contact.depth, normalStiffness, tangentialStiffness, 1};
    }
};

} // namespace chesil
