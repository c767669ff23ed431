#pragma once

#include "core/contact/contactState.hpp"
#include "core/contact/tangentPlane.hpp"
#include "core/dynamics/bodies.hpp"

namespace chesil
{

/// Sum of m v^2/2 + I w^2/2 over the bodies that move [J], per unit depth in 2D.
inline double kineticEnergy(const Bodies<2>& bodies)
{
    double sum = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        if (bodies.inverseMass[i] > 0)
        {
            sum += 0.5 * bodies.velocity[i].squaredNorm() / bodies.inverseMass[i];
        }
        if (bodies.inverseInertia[i] > 0)
        {
            sum += 0.5 * bodies.angularVelocity[i] * bodies.angularVelocity[i] / bodies.inverseInertia[i];
        }
    }
    return sum;
}

/// Of all forces and torques at the present velocities, on the bodies that move [W].
inline double powerOfForces(const Bodies<2>& bodies)
{
    double sum = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        sum += bodies.inverseMass[i] > 0 ? bodies.force[i].dot(bodies.velocity[i]) : 0;
        sum += bodies.inverseInertia[i] > 0 ? bodies.torque[i] * bodies.angularVelocity[i] : 0;
    }
    return sum;
}

/// Energy stored in a contact's normal and tangential spring, and by its attraction (negative) [J]; `stretch` is the
/// tangential one's [m].
template <class Law, int Dim>
double elasticEnergy(const Law& law, const ContactState<Dim>& contact, const Tangential<Dim>& stretch)
{
    const ContactSprings springs = law.springs(contact);
    return Law::energyShare * springs.normalForce * contact.depth
        + 0.5 * springs.tangentialStiffness * TangentPlane<Dim>::dot(stretch, stretch) - law.attraction(contact) * contact.depth;
}

} // namespace chesil
