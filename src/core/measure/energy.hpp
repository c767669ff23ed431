#pragma once

#include "core/contact/contact.hpp"
#include "core/contact/linearLaw.hpp"
#include "core/dynamics/bodies.hpp"

#include <vector>

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

/// Energy stored in all contacts [J].
inline double contactEnergy(const LinearLaw& law, const std::vector<Contact<2>>& contacts)
{
    double sum = 0;
    for (const Contact<2>& contact : contacts)
    {
        if (contact.depth > 0)
        {
            sum += elasticEnergy(law, contact.depth, contact.spring);
        }
    }
    return sum;
}

} // namespace chesil
