#include "core/dynamics/mostTravel.hpp"

#include "unit/core/world/worldScenes.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

// A fast grain hits what is in its way, or the step is refused; it never comes out on the other side.

using namespace chesil;

namespace
{

enum class End
{
    hit,
    refused,
    passedThrough,
    gaveUp
};

/// Grain 0 flies up at grain 1, at rest.
End end(WorldSettings settings, double share)
{
    World world(settings);
    const double timeStep = share * world.stableTimeStep();
    world.updateForces();
    bool touched = false;
    for (int i = 0; i < 200000; ++i)
    {
        const StepStatus status = world.step(timeStep);
        if (status != StepStatus::done)
        {
            EXPECT_TRUE(status == StepStatus::tooFast || status == StepStatus::tooDeep) << describe(status, world.brokenGrain());
            EXPECT_LT(world.brokenGrain(), 2u);
            return End::refused;
        }
        touched = touched || world.largestRelativeOverlap() > 0;
        const auto& pose = world.bodies().pose;
        if (pose[0].position.y() > pose[1].position.y())
        {
            return End::passedThrough;
        }
        if (touched && world.largestRelativeOverlap() == 0)
        {
            return End::hit;
        }
    }
    return End::gaveUp;
}

} // namespace

TEST(FastGrains, hitOrAreRefused)
{
    int hits = 0;
    int refusals = 0;
    int passed = 0;
    const std::vector<NamedShape> shapes = test::shapesOfEachKind(5);
    for (const double share : {0.5, 1.0})
    {
        for (const double size : {1.0, 0.1, 0.01})
        {
            for (double speed = 0.1; speed < 1e6; speed *= 3)
            {
                for (std::size_t kind = 0; kind < 4; ++kind)
                {
                    WorldSettings settings = test::freeBall();
                    settings.shapes = {shapes[kind], {"small", Circle(0.025 * size)}};
                    settings.grains[0].velocity = Vector2(0, speed);
                    settings.grains[0].position = Vector2(0, -0.0351 - 0.025 * size);
                    settings.walls.clear();
                    settings.grains.resize(2);
                    settings.grains[1].shape = 1;
                    const End atGrain = end(settings, share);
                    hits += atGrain == End::hit;
                    refusals += atGrain == End::refused;
                    passed += atGrain == End::passedThrough;
                    EXPECT_NE(atGrain, End::gaveUp);
                    EXPECT_NE(atGrain, End::passedThrough) << shapes[kind].name << " at " << speed << " m/s, size " << size << ", share " << share;
                }
            }
        }
    }
    std::printf("%d hits, %d steps refused, %d passed through\n", hits, refusals, passed);
    EXPECT_GT(hits, 50);
    EXPECT_GT(refusals, 50);
    test::record("dryEngine", "tunnelled", passed, "-");
}

TEST(FastGrains, neverLeaveThroughAWall)
{
    for (double speed = 0.1; speed < 1e6; speed *= 3)
    {
        WorldSettings settings = test::freeBall();
        settings.walls = {{"lid", Vector2(0, 0), Vector2(0, -1)}};
        settings.grains[0].position = Vector2(0, -0.06);
        settings.grains[0].velocity = Vector2(0, speed);
        World world(settings);
        const double timeStep = 0.5 * world.stableTimeStep();
        world.updateForces();
        for (int i = 0; i < 2000 && world.bodies().velocity[0].y() > 0; ++i)
        {
            ASSERT_EQ(world.step(timeStep), StepStatus::done);
        }
        for (int i = 0; i < 2000 && !world.contacts().empty(); ++i)
        {
            ASSERT_EQ(world.step(timeStep), StepStatus::done);
        }
        EXPECT_LT(world.bodies().pose[0].position.y(), 0) << speed;
        EXPECT_NEAR(world.bodies().velocity[0].y() / speed, -1, 0.06) << speed;
    }
}

TEST(FastGrains, areNamed)
{
    WorldSettings settings = test::freeBall();
    settings.grains.resize(2);
    settings.grains[1].position = Vector2(1, 0);
    settings.grains[1].velocity = Vector2(1e5, 0);
    World world(settings);
    world.updateForces();
    ASSERT_EQ(world.step(0.5 * world.stableTimeStep()), StepStatus::tooFast);
    EXPECT_EQ(world.brokenGrain(), 1u);
    EXPECT_EQ(world.time(), 0);
    EXPECT_NE(describe(StepStatus::tooFast, 1).find("grain 1 is so fast"), std::string::npos);
}

TEST(FastGrains, spinningNeedlesToo)
{
    WorldSettings settings = test::freeBall();
    settings.shapes = {{"needle", Ellipse(0.1, 0.002)}};
    settings.grains.resize(2);
    settings.grains[1].position = Vector2(1, 0);
    World slow(settings);
    const double timeStep = 0.5 * slow.stableTimeStep();
    settings.grains[0].angularVelocity = 1.01 * 0.002 / 2 / (0.1 * timeStep);
    World fast(settings);
    fast.updateForces();
    EXPECT_EQ(fast.step(timeStep), StepStatus::tooFast);
    EXPECT_EQ(fast.step(0.9 * timeStep), StepStatus::done);
}

TEST(FastGrains, aStepThatIsNoPositiveNumberDoesNothing)
{
    WorldSettings settings = test::freeBall();
    settings.gravity = Vector2(0, -9.81);
    World world(settings);
    world.updateForces();
    const Vector2 position = world.bodies().pose[0].position;
    for (const double timeStep : {0.0, -1e-6, std::nan(""), HUGE_VAL, -HUGE_VAL})
    {
        EXPECT_EQ(world.step(timeStep), StepStatus::badTimeStep) << timeStep;
        EXPECT_EQ(world.bodies().pose[0].position, position);
        EXPECT_EQ(world.bodies().velocity[0], Vector2::Zero());
        EXPECT_EQ(world.time(), 0);
    }
    EXPECT_NE(describe(StepStatus::badTimeStep, 0), "");
}
