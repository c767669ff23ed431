#pragma once

#include "core/contact/contactState.hpp"
#include "core/contact/tangentPlane.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

/// What a contact does to the first body; the second gets the opposite.
template <int Dim>
struct ContactForce
{
    /// [N].
    Vector<Dim> force;
    /// Size of the repulsion that friction rests on [N]: elastic and damping part, never negative.
    double pressing;
    /// Of the normal dashpot [N s/m].
    double damping;
    ContactSprings springs;
};

/// `spring` is the elastic tangential displacement of the first body against the second [m], carried from step
/// to step: it is lengthened by this step's slip and cut to what friction holds. Null without friction. Springs and
/// dashpots never attract; the law's attraction does. The laws: linearLaw.hpp, hertzMindlinLaw.hpp. `loss`, if not null,
/// grows by what dashpots and slip take in this step [J].
template <class Law, int Dim>
[[gnu::always_inline]] inline ContactForce<Dim> contactForce(const Law& law, const ContactState<Dim>& contact, double timeStep, Tangential<Dim>* spring, double* loss = nullptr)
{
    const ContactSprings springs = law.springs(contact);
    const double approach = contact.relativeVelocity.dot(contact.normal);
    const double dashpot = 2 * Law::dampingFactor * law.dampingRatio;
    const double damping = dashpot * std::sqrt(contact.effectiveMass * springs.normalStiffness);
    const double pressing = std::max(0.0, springs.normalForce + damping * approach);
    const Vector<Dim> normalPart = (law.attraction(contact) - pressing) * contact.normal;
    if (loss)
    {
        *loss += timeStep * (pressing - springs.normalForce) * approach;
    }
    if (!spring)
    {
        return {normalPart, pressing, damping, springs};
    }

    using Plane = TangentPlane<Dim>;
    Tangential<Dim>& stretch = *spring;
    const double scale = std::min(springs.stiffnessRatio, 1.0);
    if (loss)
    {
        *loss += springs.tangentialStiffness / 2 * (springs.stiffnessRatio - scale * scale) * Plane::dot(stretch, stretch);
    }
    const Tangential<Dim> slip = Plane::of(contact.relativeVelocity, contact.normal);
    const Tangential<Dim> way = timeStep * slip;
    const Tangential<Dim> unslipped = scale * stretch + way;
    stretch = unslipped;

    const double tangentialDamping = dashpot * std::sqrt(contact.effectiveMass * springs.tangentialStiffness);
    Tangential<Dim> tangentialForce = -springs.tangentialStiffness * stretch - tangentialDamping * slip;
    const double size = Plane::norm(tangentialForce);
    const double most = law.friction * pressing;
    if (size > most)
    {
        tangentialForce *= most / size;
        stretch = -(tangentialForce + tangentialDamping * slip) / springs.tangentialStiffness;
    }
    if (loss)
    {
        // The spring's mean force over the step times the way that it has not followed, and the dashpot.
        const Tangential<Dim> meanStretch = (unslipped - way + stretch) / 2;
        *loss += tangentialDamping * Plane::dot(slip, way)
            + springs.tangentialStiffness * Plane::dot(meanStretch, unslipped - stretch);
    }
    return {normalPart + Plane::inWorld(tangentialForce, contact.normal), pressing, damping, springs};
}

} // namespace chesil
