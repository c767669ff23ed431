#include "core/world/resultantForces.hpp"

#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace chesil;

namespace
{

World afterSteps(const WorldSettings& settings, int steps)
{
    World world(settings);
    world.updateForces();
    const double timeStep = world.stableTimeStep() / 2;
    for (int i = 0; i < steps; ++i)
    {
        EXPECT_EQ(world.step(timeStep), StepStatus::done);
    }
    return world;
}

} // namespace

TEST(ResultantForces, areWhatMovesUndampedGrains)
{
    WorldSettings settings = test::mixedScene(30, 71);
    settings.localDamping = 0;
    const World world = afterSteps(settings, 3000);
    const std::vector<Vector2> forces = resultantForces(world);
    double largest = 0;
    double worst = 0;
    for (std::size_t i = 0; i < forces.size(); ++i)
    {
        largest = std::max(largest, forces[i].norm());
        worst = std::max(worst, (forces[i] - world.bodies().force[i]).norm());
    }
    EXPECT_TRUE(std::any_of(
        world.contacts().begin(), world.contacts().end(), [](const Contact<2>& contact) { return contact.depth > 0; }));
    EXPECT_LT(worst, 1e-12 * largest);
}

TEST(ResultantForces, doNotHoldTheDamping)
{
    // A ball that falls: its weight, of which damping has taken 0.7.
    WorldSettings settings = test::freeBall();
    settings.gravity = Vector2(0, -9.81);
    settings.localDamping = 0.7;
    const World world = afterSteps(settings, 10);
    const double weight = 2650 * M_PI * 0.05 * 0.05 * 9.81;
    EXPECT_NEAR(resultantForces(world)[0].y(), -weight, 1e-9 * weight);
    EXPECT_NEAR(world.bodies().force[0].y(), -0.3 * weight, 1e-9 * weight);
}

TEST(ResultantForces, countBothSidesOfAContactAcrossACell)
{
    WorldSettings settings = test::freeBall();
    settings.shapes = {{"ball", Circle(0.05)}};
    settings.grains.resize(2);
    settings.grains[0].position = Vector2(0.049, 0.3);
    settings.grains[1].position = Vector2(0.551, 0.3);
    settings.cell.emplace(PeriodicCell(Vector2(0, 0), Vector2(0.6, 0), Vector2(0, 0.6)));
    World world(settings);
    world.updateForces();
    const std::vector<Vector2> forces = resultantForces(world);
    EXPECT_NEAR(forces[0].x(), 1e6 * 0.002, 1e-6);
    EXPECT_EQ(forces[0], -forces[1]);
}
