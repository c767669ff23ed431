#pragma once

#include "core/contact/contactForce.hpp"

#include <cmath>

/// Impacts of spheres by a law alone, small steps of kick-drift-kick.
namespace chesil::test
{

/// A sphere that flies at a plane.
struct Sphere
{
    double radius;
    double density;
    double mass() const { return 4.0 / 3.0 * M_PI * radius * radius * radius * density; }
    double inertia() const { return 0.4 * mass() * radius * radius; }
};

struct Impact
{
    double largestDepth = 0;
    double largestForce = 0;
    double duration = 0;
    /// Normal (away from the plane), tangential velocity of the centre [m/s] and spin [rad/s] afterwards.
    double normal = 0;
    double tangential = 0;
    double spin = 0;
};

/// The sphere's centre moves by (tangential, -normal) before; `effectiveMass` of its mass moves (1/2: against its like).
/// `spin` counter-clockwise; the plane lies below.
template <class Law>
Impact impactOf(const Law& law, const Sphere& sphere, double effectiveRadius, double effectiveMass, double normal, double tangential, double timeStep)
{
    const Vector2 down(0, -1);
    double spring = 0;
    Vector2 velocity(tangential, -normal);
    Vector2 force = Vector2::Zero();
    double spin = 0;
    double torque = 0;
    double depth = 0;
    Impact result;
    const double inertia = sphere.inertia() * effectiveMass / sphere.mass();
    for (int step = 0; step == 0 || depth > 0; ++step)
    {
        velocity += timeStep / 2 / effectiveMass * force;
        spin += timeStep / 2 / inertia * torque;
        const double before = depth;
        depth -= timeStep * velocity.y();
        force = Vector2::Zero();
        torque = 0;
        if (depth > 0)
        {
            const Vector2 atContact = velocity + spin * sphere.radius * Vector2(1, 0);
            ContactState<2> state{depth, down, atContact, 1 / effectiveMass, effectiveRadius, before};
            force = contactForce(law, state, timeStep, law.frictional() ? &spring : nullptr).force;
            torque = force.x() * sphere.radius;
            result.duration += timeStep;
        }
        velocity += timeStep / 2 / effectiveMass * force;
        spin += timeStep / 2 / inertia * torque;
        result.largestDepth = std::max(result.largestDepth, depth);
        result.largestForce = std::max(result.largestForce, force.y());
    }
    result.normal = velocity.y();
    result.tangential = velocity.x();
    result.spin = spin;
    return result;
}

} // namespace chesil::test
