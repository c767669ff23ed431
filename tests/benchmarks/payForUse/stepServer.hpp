#pragma once

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/payForUse/diskScenes.hpp"

#include <iostream>

namespace chesil::benchmark
{

/// Changes with any bit of any grain's place.
inline double fingerprintOf(const World& world)
{
    double sum = 0;
    for (const Pose<2>& pose : world.bodies().pose)
    {
        sum = 0.999 * sum + pose.position.x() + 3 * pose.position.y();
    }
    return sum;
}

/// Runs as many steps of the scene "bed" or "gas" as each line of the standard input says, and answers with
/// the CPU time [s] and the fingerprint of the state. Two programs that are asked in turn run under the same
/// conditions.
inline void serveSteps(const std::string& scene)
{
    World world(scene == "bed" ? bedOf(diskShapes(), ratioGrains) : gasOf(diskShapes(), ratioGrains));
    const double timeStep = world.stableTimeStep();
    world.updateForces();
    for (int steps = 0; std::cin >> steps;)
    {
        const double start = cpuSeconds();
        runSteps(world, timeStep, steps);
        std::printf("%.9g %a\n", cpuSeconds() - start, fingerprintOf(world));
        std::fflush(stdout);
    }
}

/// The main of a program that serves steps: its last argument is the scene.
inline int mainOfServer(int argumentCount, char** arguments)
{
    try
    {
        serveSteps(arguments[argumentCount - 1]);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s: %s\n", arguments[0], error.what());
        return 1;
    }
    return 0;
}

} // namespace chesil::benchmark
