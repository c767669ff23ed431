#pragma once

#include "benchmarks/common/benchmark.hpp"
#include "core/measure/energy.hpp"
#include "core/world/world.hpp"

namespace chesil::benchmark
{

/// How well a run keeps its energy. Relative to the energy at the start.
struct EnergyErrors
{
    /// Over the samples at which nothing touches.
    double largest = 0;
    /// At the end, what the contacts store included.
    double last = 0;
    /// CPU time [s] of the run.
    double seconds = 0;
};

/// Kinetic energy, height times weight above the origin, and what the contacts store [J].
inline double totalEnergy(const World& world)
{
    const Bodies<2>& bodies = world.bodies();
    double energy = kineticEnergy(bodies) + world.contactEnergy();
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        energy -= world.settings().gravity.dot(bodies.pose[i].position) / bodies.inverseMass[i];
    }
    return energy;
}

inline bool inFlight(const World& world)
{
    return std::none_of(world.contacts().begin(), world.contacts().end(),
                        [](const Contact<2>& contact) { return contact.depth > 0; });
}

/// Runs `samples` times `stepsBetween` steps of the given size [s].
inline EnergyErrors runWorld(const WorldSettings& settings, double timeStep, int samples, int stepsBetween)
{
    const double start = cpuSeconds();
    World world(settings);
    world.updateForces();
    const double energyAtStart = totalEnergy(world);
    EnergyErrors errors;
    for (int sample = 0; sample < samples; ++sample)
    {
        for (int step = 0; step < stepsBetween; ++step)
        {
            if (world.step(timeStep) != StepStatus::done)
            {
                throw std::runtime_error("a grain's motion is no longer finite");
            }
        }
        errors.last = std::abs(totalEnergy(world) / energyAtStart - 1);
        if (inFlight(world))
        {
            errors.largest = std::max(errors.largest, errors.last);
        }
    }
    errors.seconds = cpuSeconds() - start;
    return errors;
}

} // namespace chesil::benchmark
