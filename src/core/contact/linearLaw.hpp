#pragma once

#include "core/base/vector.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

/// Linear springs and dashpots with Coulomb friction (Cundall & Strack 1979). Per unit depth in 2D.
struct LinearLaw
{
    /// [N/m] > 0.
    double normalStiffness = 0;
    /// [N/m] >= 0; 0 means no tangential force.
    double tangentialStiffness = 0;
    /// Coulomb coefficient >= 0.
    double friction = 0;
    /// Share of critical damping of the pair's effective mass, >= 0.
    double dampingRatio = 0;

    bool frictional() const { return friction > 0 && tangentialStiffness > 0; }
};

/// The coefficient of restitution of a linear contact with the damping ratio z >= 0 whose force never attracts.
/// The damped oscillator lets go when its force changes sign, at the time 2 arccos(z)/(w sqrt(1 - z^2)), before
/// the overlap is back at zero: e = exp(-2 z arccos(z)/sqrt(1 - z^2)); beyond z = 1 with arcosh and z^2 - 1.
inline double restitutionOf(double dampingRatio)
{
    const double square = dampingRatio * dampingRatio;
    if (std::abs(1 - square) < 1e-10)
    {
        return std::exp(-2.0);
    }
    const double angle = square < 1 ? std::acos(dampingRatio) : std::acosh(dampingRatio);
    return std::exp(-2 * dampingRatio * angle / std::sqrt(std::abs(1 - square)));
}

/// The damping ratio that gives the coefficient of restitution e, 0 < e <= 1; the inverse of restitutionOf.
inline double dampingRatioOf(double restitution)
{
    // e falls from 1, and below 1/(2 z)^2: bisection for one of set-up's few calls.
    double low = 0;
    double high = std::max(1.0, 0.5 / std::sqrt(restitution));
    for (double middle = high / 2; low < middle && middle < high; middle = (low + high) / 2)
    {
        (restitutionOf(middle) > restitution ? low : high) = middle;
    }
    return low;
}

/// What a law needs to know of a contact at one instant, world frame.
template <int Dim>
struct ContactState
{
    double depth;
    /// Unit, from the first body to the second.
    Vector<Dim> normal;
    /// Velocity of the first body less that of the second, at the contact point [m/s].
    Vector<Dim> relativeVelocity;
    /// m1 m2/(m1 + m2) [kg].
    double effectiveMass;
};

/// Force on the first body [N]; the second gets its opposite. `spring` is the elastic tangential displacement
/// of the first body against the second [m], carried from step to step: it is turned into the new tangent
/// plane, lengthened by this step's slip and cut to what friction holds. The normal force is never attractive.
template <int Dim>
Vector<Dim> contactForce(const LinearLaw& law, const ContactState<Dim>& contact, double timeStep, Vector<Dim>& spring)
{
    const double approach = contact.relativeVelocity.dot(contact.normal);
    const double damping = 2 * law.dampingRatio * std::sqrt(contact.effectiveMass * law.normalStiffness);
    const double normalForce = std::max(0.0, law.normalStiffness * contact.depth + damping * approach);
    const Vector<Dim> normalPart = -normalForce * contact.normal;
    if (!law.frictional())
    {
        return normalPart;
    }

    const double length = spring.norm();
    spring -= spring.dot(contact.normal) * contact.normal;
    const double projected = spring.norm();
    if (projected > 0)
    {
        spring *= length / projected;
    }
    const Vector<Dim> slip = contact.relativeVelocity - approach * contact.normal;
    spring += timeStep * slip;

    const double tangentialDamping = 2 * law.dampingRatio * std::sqrt(contact.effectiveMass * law.tangentialStiffness);
    Vector<Dim> tangentialForce = -law.tangentialStiffness * spring - tangentialDamping * slip;
    const double size = tangentialForce.norm();
    const double most = law.friction * normalForce;
    if (size > most)
    {
        tangentialForce *= most / size;
        spring = -(tangentialForce + tangentialDamping * slip) / law.tangentialStiffness;
    }
    return normalPart + tangentialForce;
}

/// Energy stored in the two springs [J].
template <int Dim>
double elasticEnergy(const LinearLaw& law, double depth, const Vector<Dim>& spring)
{
    return 0.5 * (law.normalStiffness * depth * depth + law.tangentialStiffness * spring.squaredNorm());
}

} // namespace chesil
