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

/// Share of a dashpot's force that makes up for the part of a step for which the contact was not yet there. A force
/// found at a step's end stands for half a step before and after; in a contact that is less than a step's `way` [m] deep,
/// it acts from its beginning on. Without it a restitution errs by the dashpot's impulse over half a step.
template <class Law, int Dim>
double begun(const ContactState<Dim>& contact, double way)
{
    return Law::dampsAtOnce && contact.previousDepth == 0 && contact.depth < way ? 0.5 + contact.depth / way : 1;
}

/// The same of an attraction, which is there in full from the first touch to the last: for a contact that has begun
/// within the step before this instant or, by its velocity, ends within the one after. Without it each touch and each
/// parting errs by the work of the attraction over up to half a step's way.
template <int Dim>
double present(const ContactState<Dim>& contact, double way)
{
    const bool beginsOrEnds = way < 0 || contact.previousDepth == 0;
    return beginsOrEnds && contact.depth < std::abs(way) ? 0.5 + contact.depth / std::abs(way) : 1;
}

/// `spring` is the elastic tangential displacement of the first body against the second [m], carried from step
/// to step: it is lengthened by this step's slip and cut to what friction holds. Null without friction. The velocity is
/// that of the half step before. If the state anticipates, the normal dashpot works on that of the full step, F = f + c (v + g - (F - F') dt/(2 m))
/// with the gain g expected from the forces of the step before, this contact's F' among them, solved for F: exact for two
/// bodies that meet centrally, and nothing at rest. Springs and dashpots never attract; the law's attraction does. The
/// laws: linearLaw.hpp, hertzMindlinLaw.hpp. `loss`, if not null, grows by what dashpots and slip take in this step [J].
template <class Law, int Dim>
[[gnu::always_inline]] inline ContactForce<Dim> contactForce(const Law& law, const ContactState<Dim>& contact, double timeStep, Tangential<Dim>* spring, double* loss = nullptr)
{
    const ContactSprings springs = law.springs(contact);
    const double approach = contact.relativeVelocity.dot(contact.normal);
    const double dashpot = 2 * Law::dampingFactor * law.dampingRatio;
    double attraction = law.attraction(contact);
    if (attraction > 0)
    {
        attraction *= present(contact, approach * timeStep);
    }
    const bool damped = dashpot > 0 && contact.inverseMass > 0;
    const double mass = damped ? 1 / contact.inverseMass : 0;
    const double dampingRate = damped ? dashpot * std::sqrt(contact.inverseMass * springs.normalStiffness) : 0;
    const double damping = dampingRate * mass;
    double pressing = springs.normalForce;
    if (damped)
    {
        pressing += damping * begun<Law>(contact, approach * timeStep) * (approach + contact.expectedGain);
        if (contact.anticipates)
        {
            const double held = dampingRate * timeStep / 2;
            pressing = (pressing + held * (contact.previousForce + attraction)) / (1 + held);
        }
        pressing = std::max(0.0, pressing);
    }
    const Vector<Dim> normalPart = (attraction - pressing) * contact.normal;
    if (loss)
    {
        const double slowing = damped && contact.anticipates ? timeStep / 2 * contact.inverseMass : 0;
        const double atEnd = approach + contact.expectedGain - slowing * (pressing - attraction - contact.previousForce);
        *loss += timeStep * (pressing - springs.normalForce) * atEnd;
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

    const double tangentialDamping = damped ? dashpot * std::sqrt(mass * springs.tangentialStiffness) : 0;
    Tangential<Dim> tangentialForce = -springs.tangentialStiffness * stretch - tangentialDamping * slip;
    const double size = Plane::norm(tangentialForce);
    const double most = law.friction * pressing;
    if (size > most)
    {
        // The spring is cut to what friction holds, and never lengthened by the dashpot's force: that would be energy
        // from nowhere.
        tangentialForce *= most / size;
        const double pull = springs.tangentialStiffness * Plane::norm(stretch);
        stretch *= pull > most ? most / pull : 1;
    }
    if (loss)
    {
        // The dashpot's force, and the spring's mean one over the step times the way that it has not followed.
        const Tangential<Dim> meanStretch = (unslipped - way + stretch) / 2;
        *loss += springs.tangentialStiffness * Plane::dot(meanStretch, unslipped - stretch)
            - Plane::dot(tangentialForce + springs.tangentialStiffness * stretch, way);
    }
    return {normalPart + Plane::inWorld(tangentialForce, contact.normal), pressing, damping, springs};
}

} // namespace chesil
