#include "core/measure/energy.hpp"
#include "core/world/placement.hpp"
#include "core/world/world.hpp"

#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

constexpr double radius = 0.01;
constexpr double density = 2650;

WorldSettings boxOfDisks(int number, double side, double stiffness)
{
    WorldSettings settings;
    for (const double r : {0.8 * radius, radius})
    {
        settings.shapes.push_back({"disk", Circle(r)});
    }
    settings.materials[0].density = density;
    settings.linear().normalStiffness = stiffness;
    settings.linear().tangentialStiffness = stiffness;
    settings.walls = {{"floor", Vector2::Zero(), Vector2::UnitY()},
                      {"left", Vector2::Zero(), Vector2::UnitX()},
                      {"right", Vector2(side, 0), -Vector2::UnitX()},
                      {"lid", Vector2(0, side), -Vector2::UnitY()}};
    if (number > 0)
    {
        settings.grains = placeOnLattice(settings.shapes, {0, 1}, number, {Vector2::Zero(), Vector2(side, side)}, 7);
    }
    return settings;
}

} // namespace

TEST(MovingWalls, aBeltCarriesADisk)
{
    // Friction spins and pushes until the point of contact goes with the belt: m v = J, I w = J r, v + w r = belt.
    WorldSettings settings = boxOfDisks(0, 1, 1e6);
    settings.linear().friction = 0.5;
    settings.linear().dampingRatio = 0.3;
    settings.gravity = Vector2(0, -9.81);
    settings.walls.resize(1);
    settings.walls[0].motion = DrivenWall{Vector2(1, 0)};
    GrainState disk;
    disk.shape = 1;
    disk.position = Vector2(0, radius);
    settings.grains.push_back(disk);
    World world(settings);
    const double timeStep = world.stableTimeStep() / 4;
    while (world.time() < 0.5)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done);
    }
    EXPECT_NEAR(world.bodies().velocity[0].x(), 1.0 / 3, 1e-3);
    EXPECT_NEAR(world.walls()[0].point.x(), world.time(), 1e-12);
}

TEST(MovingWalls, aPistonsWorkIsTheGasEnergy)
{
    double errors[2];
    for (const int finer : {1, 2})
    {
        WorldSettings settings = boxOfDisks(60, 0.3, 1e6);
        test::RandomSource random(5);
        for (GrainState& grain : settings.grains)
        {
            grain.velocity = random.direction();
        }
        settings.walls[3].motion = DrivenWall{Vector2(0, -0.2), Vector2(0, 0.01), 20};
        World world(settings);
        world.updateForces();
        const double start = kineticEnergy(world.bodies()) + world.contactEnergy();
        const double timeStep = world.stableTimeStep() / 8 / finer;
        double worst = 0;
        while (world.time() < 0.2)
        {
            ASSERT_EQ(world.step(timeStep), StepStatus::done);
            const double energy = kineticEnergy(world.bodies()) + world.contactEnergy();
            worst = std::max(worst, std::abs(energy - start - world.wallStates()[3].work));
        }
        EXPECT_GT(world.wallStates()[3].work, 0.1 * start) << "it has worked";
        errors[finer - 1] = worst / start;
    }
    EXPECT_LT(errors[0], 1e-2);
    EXPECT_LT(errors[1], errors[0] / 2) << "the ledger closes with the step";
}

TEST(MovingWalls, servoWallsReachTheirPressureWhateverTheStiffness)
{
    constexpr double pressure = 1e3;
    constexpr double duration = 2.5;
    for (const double stiffness : {1e5, 1e6, 1e7})
    {
        WorldSettings settings = boxOfDisks(40, 0.2, stiffness);
        settings.linear().dampingRatio = 0.3;
        settings.localDamping = 0.7;
        settings.walls[2].motion = ServoWall{pressure, 1, {0, 3}};
        settings.walls[3].motion = ServoWall{pressure, 1, {1, 2}};
        World world(settings);
        const double timeStep = world.stableTimeStep() / 2;
        while (world.time() < duration)
        {
            ASSERT_EQ(world.step(timeStep), StepStatus::done);
        }
        const Vector2 corner(world.walls()[2].point.x(), world.walls()[3].point.y());
        EXPECT_NEAR(world.wallStates()[2].force.x() / corner.y() / pressure, 1, 1e-3) << stiffness;
        EXPECT_NEAR(world.wallStates()[3].force.y() / corner.x() / pressure, 1, 1e-3) << stiffness;
    }
}

TEST(MovingWalls, aServoWallInAnEmptyBoxGoesAtItsSpeed)
{
    WorldSettings settings = boxOfDisks(0, 1, 1e6);
    settings.walls[3].motion = ServoWall{1e3, 0.5, {1, 2}};
    GrainState disk;
    disk.position = Vector2(0.5, 0.01);
    settings.grains.push_back(disk);
    World world(settings);
    for (int step = 0; step < 100; ++step)
    {
        ASSERT_EQ(world.step(1e-4), StepStatus::done);
    }
    EXPECT_NEAR(world.walls()[3].point.y(), 1 - 0.5 * 1e-2, 1e-12);
}
