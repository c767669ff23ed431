#pragma once

#include "core/contact/contactState.hpp"
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

/// Energy stored in a contact's normal and tangential spring [J]; `stretch` is the tangential one's [m]. Without cohesion.
template <class Law, int Dim>
double elasticEnergy(const Law& law, const ContactState<Dim>& contact, const Vector<Dim>& stretch)
{
    const ContactSprings springs = law.springs(contact);
    return Law::energyShare * springs.normalForce * contact.depth
        + 0.5 * springs.tangentialStiffness * stretch.squaredNorm();
}

} // namespace chesil
