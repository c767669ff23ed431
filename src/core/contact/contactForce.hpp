#pragma once

#include "core/contact/contactState.hpp"

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
/// found at a step's end stands for half a step before and after; in a contact that is `way` [m] less than a step's way
/// deep, it acts from its beginning on. Without it a restitution errs by the dashpot's impulse over half a step.
template <class Law, int Dim>
double begun(const ContactState<Dim>& contact, double way)
{
    return Law::dampsAtOnce && contact.previousDepth == 0 && contact.depth < way ? 0.5 + contact.depth / way : 1;
}

/// `spring` is the elastic tangential displacement of the first body against the second [m], carried from step
/// to step: it is turned into the new tangent plane, lengthened by this step's slip and cut to what friction
/// holds. Null without friction. The velocity is that of the half step before, and the normal dashpot works on that of
/// the full step, F = f + c (v - F dt/(2 m)), solved for F: exact for two bodies that meet centrally. Springs and dashpots never attract; cohesion does. The laws: linearLaw.hpp,
/// hertzMindlinLaw.hpp. `loss`, if not null, grows by what dashpots and slip take in this step [J].
template <class Law, int Dim>
ContactForce<Dim> contactForce(const Law& law, const ContactState<Dim>& contact, double timeStep, Vector<Dim>* spring, double* loss = nullptr)
{
    const ContactSprings springs = law.springs(contact);
    const double approach = contact.relativeVelocity.dot(contact.normal);
    const double dashpot = 2 * Law::dampingFactor * law.dampingRatio;
    const double damping = dashpot * std::sqrt(contact.effectiveMass * springs.normalStiffness);
    const double slowing = contact.effectiveMass > 0 ? timeStep / (2 * contact.effectiveMass) : 0;
    const double pressing =
        std::max(0.0, (springs.normalForce + begun<Law>(contact, approach * timeStep) * damping * approach) / (1 + damping * slowing));
    const Vector<Dim> normalPart = (law.cohesion - pressing) * contact.normal;
    if (loss)
    {
        *loss += timeStep * (pressing - springs.normalForce) * (approach - slowing * (pressing - law.cohesion));
    }
    if (!spring)
    {
        return {normalPart, pressing, damping, springs};
    }

    Vector<Dim>& stretch = *spring;
    const double scale = std::min(springs.stiffnessRatio, 1.0);
    if (loss)
    {
        *loss += springs.tangentialStiffness / 2 * (springs.stiffnessRatio - scale * scale) * stretch.squaredNorm();
    }
    const double length = stretch.norm() * scale;
    stretch -= stretch.dot(contact.normal) * contact.normal;
    const double projected = stretch.norm();
    if (projected > 0)
    {
        stretch *= length / projected;
    }
    const Vector<Dim> slip = contact.relativeVelocity - approach * contact.normal;
    stretch += timeStep * slip;
    const Vector<Dim> unslipped = stretch;

    const double tangentialDamping = dashpot * std::sqrt(contact.effectiveMass * springs.tangentialStiffness);
    Vector<Dim> tangentialForce = -springs.tangentialStiffness * stretch - tangentialDamping * slip;
    const double size = tangentialForce.norm();
    const double most = law.friction * pressing;
    if (size > most)
    {
        // The spring is cut to what friction holds, and never lengthened by the dashpot's force: that would be energy
        // from nowhere.
        tangentialForce *= most / size;
        const double pull = springs.tangentialStiffness * stretch.norm();
        stretch *= pull > most ? most / pull : 1;
    }
    if (loss)
    {
        // The dashpot's force, and the spring's mean one over the step times the way that it has not followed.
        const Vector<Dim> way = timeStep * slip;
        const Vector<Dim> meanStretch = (unslipped - way + stretch) / 2;
        *loss += springs.tangentialStiffness * meanStretch.dot(unslipped - stretch)
            - (tangentialForce + springs.tangentialStiffness * stretch).dot(way);
    }
    return {normalPart + tangentialForce, pressing, damping, springs};
}

} // namespace chesil
