#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

} // namespace

TEST(World, withoutGrainsAndWithOne)
{
    World empty(test::quartzSettings());
    EXPECT_EQ(empty.stableTimeStep(), std::numeric_limits<double>::infinity());
    empty.updateForces();
    EXPECT_EQ(empty.step(1e-3), StepStatus::done);
    EXPECT_EQ(empty.largestRelativeOverlap(), 0);

    WorldSettings settings = test::freeBall();
    settings.gravity = Vector2(0, -10);
    settings.grains[0].velocity = Vector2(3, 0);
    World one(settings);
    one.updateForces();
    for (int i = 0; i < 1000; ++i)
    {
        ASSERT_EQ(one.step(1e-3), StepStatus::done);
    }
    // Velocity Verlet is exact for a constant force.
    EXPECT_NEAR(one.bodies().pose[0].position.x(), 3, 1e-12);
    EXPECT_NEAR(one.bodies().pose[0].position.y(), -5, 1e-12);
    EXPECT_NEAR(one.bodies().velocity[0].y(), -10, 1e-12);
}

TEST(World, aGrainThatIsNoNumberIsReported)
{
    for (const int broken : {0, 5, 11})
    {
        WorldSettings settings = test::mixedScene(12, 151);
        settings.grains[static_cast<std::size_t>(broken)].velocity.y() =
            std::numeric_limits<double>::quiet_NaN();
        World world(settings);
        world.updateForces();
        EXPECT_EQ(world.step(1e-5), StepStatus::notFinite);
        EXPECT_EQ(world.brokenGrain(), static_cast<std::size_t>(broken));
    }
    WorldSettings settings = test::mixedScene(12, 151);
    settings.grains[3].angularVelocity = std::numeric_limits<double>::infinity();
    World world(settings);
    world.updateForces();
    EXPECT_EQ(world.step(1e-5), StepStatus::notFinite);
    EXPECT_EQ(world.brokenGrain(), 3u);
}

TEST(World, externalLoadsMoveAndTurnAndAreHeld)
{
    World world(test::freeBall());
    const double mass = 2650 * world.areaOf(0);
    const double inertia = 2650 * world.polarMomentOf(0);
    world.setExternalLoads({Vector2(2, -1)}, {0.5});
    world.updateForces();
    for (int i = 0; i < 100; ++i)
    {
        world.step(1e-2);
    }
    EXPECT_LT((world.bodies().velocity[0] - Vector2(2, -1) / mass).norm(), 1e-14);
    EXPECT_NEAR(world.bodies().angularVelocity[0] * inertia / 0.5, 1, 1e-12);
    EXPECT_NEAR(world.bodies().pose[0].rotation.angle() * inertia / 0.25, 1, 1e-12);
}

TEST(World, immerseGivesTheBuoyantWeightAndTheVirtualMass)
{
    WorldSettings settings = test::freeBall();
    settings.gravity = Vector2(1, -9.81);
    for (const double virtualMass : {0.0, 1.0})
    {
        World world(settings);
        world.immerse(1000, virtualMass);
        world.updateForces();
        const Vector2 weight = (2650 - 1000) * world.areaOf(0) * settings.gravity;
        EXPECT_LT((world.bodies().force[0] - weight).norm(), 8 * epsilon * weight.norm());
        world.step(0.1);
        const Vector2 expected = 0.1 * (2650 - 1000) / (2650 + virtualMass * 1000) * settings.gravity;
        EXPECT_LT((world.bodies().velocity[0] - expected).norm(), 1e-14);
        EXPECT_NEAR(world.bodies().inverseInertia[0] * (2650 + virtualMass * 1000) * world.polarMomentOf(0),
                    1, 8 * epsilon);
    }
    // Of the fluid's density it floats.
    World floating(settings);
    floating.immerse(2650, 0);
    floating.updateForces();
    EXPECT_EQ(floating.bodies().force[0], Vector2::Zero());
}

TEST(World, drivenGrainsKeepTheirVelocityButPush)
{
    WorldSettings settings = test::freeBall();
    settings.linear().friction = 0;
    settings.grains.push_back(settings.grains[0]);
    settings.grains[0].driven = true;
    settings.grains[0].velocity = Vector2(1, 0);
    settings.grains[1].position = Vector2(0.11, 0);
    World world(settings);
    world.immerse(1000, 0);
    const double timeStep = 0.1 * world.stableTimeStep();
    world.updateForces();
    while (world.bodies().pose[0].position.x() < 0.1)
    {
        world.step(timeStep);
    }
    EXPECT_EQ(world.bodies().velocity[0], Vector2(1, 0));
    // Struck by an infinite mass without loss: twice its velocity.
    EXPECT_NEAR(world.bodies().velocity[1].x(), 2, 1e-3);
}

TEST(World, theStableStepKnowsDampingStiffnessAndVirtualMass)
{
    WorldSettings settings = test::freeBall();
    settings.linear().tangentialStiffness = 0;
    const double step = World(settings).stableTimeStep();
    // A disk: 1 + m R^2/I = 3, six contacts.
    const double mass = 2650 * M_PI * 0.05 * 0.05;
    EXPECT_NEAR(step * std::sqrt(36 * 1e6 / mass), 2, 1e-12);
    settings.localDamping = 0.7;
    EXPECT_NEAR(World(settings).stableTimeStep() * std::sqrt(1.7), step, 1e-12 * step);
    settings.localDamping = 0;
    settings.linear().tangentialStiffness = 4e6;
    EXPECT_NEAR(World(settings).stableTimeStep(), step / 2, 1e-12 * step);
    settings.linear().tangentialStiffness = 0;
    settings.linear().dampingRatio = 0.1;
    EXPECT_LT(World(settings).stableTimeStep(), 0.9 * step);
    settings.linear().dampingRatio = 0;
    World wet(settings);
    wet.immerse(1000, 1);
    EXPECT_NEAR(wet.stableTimeStep(), step * std::sqrt(3650 / 2650.0), 1e-12 * step);
}
