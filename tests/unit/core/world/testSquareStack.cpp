#include "core/measure/energy.hpp"
#include "unit/core/world/worldScenes.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

#include <cstdio>

using namespace chesil;

namespace
{

constexpr int squares = 20;
constexpr double side = 0.05;

/// A stack of squares, each pressed into the one below by the weight above it, shifted sideways by up to 1 % of
/// the side and turned by up to 1e-4 rad (seeded).
WorldSettings stack(const Shape& shape)
{
    WorldSettings settings = test::quartzSettings();
    settings.linear().normalStiffness = 1e8;
    settings.linear().tangentialStiffness = 1e8;
    settings.linear().friction = 0.5;
    settings.shapes = {{"square", shape}};
    settings.walls = {test::floorWall()};
    test::RandomSource random(20);
    const double weight = settings.materials[0].density * massProperties(shape).area * 9.81;
    double top = 0;
    for (int i = 0; i < squares; ++i)
    {
        // Two places carry it, each with the stiffness of a contact.
        top -= (squares - i) * weight / (2 * settings.linear().normalStiffness);
        GrainState grain;
        grain.position = Vector2(random.uniform(-0.01, 0.01) * side, top + side / 2);
        grain.angle = random.uniform(-1e-4, 1e-4);
        settings.grains.push_back(grain);
        top += side;
    }
    return settings;
}

/// Largest move of a square over its side.
double driftAfter(const WorldSettings& settings, double duration)
{
    World world(settings);
    const double timeStep = 0.8 * world.stableTimeStep();
    world.updateForces();
    const auto steps = static_cast<long>(duration / timeStep);
    double drift = 0;
    for (long i = 0; i <= steps; ++i)
    {
        if (i % 10000 == 0 || i == steps)
        {
            for (std::size_t k = 0; k < world.bodies().size(); ++k)
            {
                drift = std::max(drift, (world.bodies().pose[k].position - settings.grains[k].position).norm() / side);
            }
        }
        if (world.step(timeStep) != StepStatus::done)
        {
            return INFINITY;
        }
    }
    return drift;
}

constexpr double bar = 1e-3;

} // namespace

TEST(SquareStack, twentyStandForAMinute)
{
    const double drift = driftAfter(stack(test::rectangle(side, side)), 60);
    std::printf("largest move of a square over its side in 60 s: %.3g\n", drift);
    EXPECT_LT(drift, bar);
    test::record("contactKernel", "squareStackDrift", drift, "-");
}

TEST(SquareStack, roundedSquaresStandToo)
{
    EXPECT_LT(driftAfter(stack(test::roundedSquare(side, 0.1 * side)), 5), bar);
}

TEST(SquareStack, standsOnContactDashpotsAlone)
{
    // No local damping: what a contact at two places stores it gives back, so that the stack cannot rock itself
    // apart (a single point that moves along the side can: doc/decisions/11-flatContacts.md).
    WorldSettings settings = stack(test::rectangle(side, side));
    settings.localDamping = 0;
    settings.linear().dampingRatio = 0.2;
    EXPECT_LT(driftAfter(settings, 5), 2 * bar);
}
