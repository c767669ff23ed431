#include "core/measure/energy.hpp"
#include "unit/core/world/worldScenes.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

/// The bars of the issue.
constexpr double weightBar = 1e-6;
constexpr double driftBar = 1e-9;
constexpr int restingSteps = 1000000;

struct Rest
{
    double weightError;
    double drift;
};

Vector2 forceOfTheFloor(const World& world)
{
    Vector2 sum = Vector2::Zero();
    for (const Contact<2>& contact : world.contacts())
    {
        sum += contact.force;
    }
    return sum;
}

/// A grain dropped askew from just above the floor, until it rests; then a million steps more.
Rest restOf(const Shape& shape)
{
    WorldSettings settings = test::quartzSettings();
    settings.shapes = {{"grain", shape}};
    settings.walls = {test::floorWall()};
    GrainState grain;
    grain.position = Vector2(0.1, 1.01 * boundingRadius(shape));
    grain.angle = 0.4;
    settings.grains = {grain};
    World world(settings);
    const double timeStep = 0.5 * world.stableTimeStep();
    const double weight = settings.materials[0].density * world.areaOf(0) * 9.81;

    world.updateForces();
    int settling = 0;
    // What is left of a rocking egg then moves it by some 1e-12 of its size.
    const double quiet = 1e-26 * weight * world.sizeOf(0);
    for (int quietSteps = 0; quietSteps < 1000 && settling < 2000000; ++settling)
    {
        EXPECT_EQ(world.step(timeStep), StepStatus::done);
        quietSteps = kineticEnergy(world.bodies()) < quiet && !world.contacts().empty() ? quietSteps + 1 : 0;
    }
    EXPECT_LT(settling, 2000000) << "it does not come to rest";

    const Pose<2> before = world.bodies().pose[0];
    double drift = 0;
    for (int i = 0; i < restingSteps; ++i)
    {
        world.step(timeStep);
        if (i % 1000 == 999)
        {
            const Pose<2>& now = world.bodies().pose[0];
            drift = std::max({drift, (now.position - before.position).norm() / world.sizeOf(0),
                              std::abs(now.rotation.angle() - before.rotation.angle())});
        }
    }
    const Vector2 unbalanced = forceOfTheFloor(world) - Vector2(0, weight);
    return {unbalanced.norm() / weight, drift};
}

} // namespace

TEST(GrainAtRest, balancesItsWeightAndDoesNotDrift)
{
    double weightError = 0;
    double drift = 0;
    test::RandomSource random(141);
    test::RandomGrainOptions pebble;
    pebble.radius = 0.025;
    const std::vector<NamedShape> shapes{{"ball", Circle(0.025)},
                                         {"egg", Ellipse(0.03, 0.02)},
                                         {"pebble", test::randomPolyBezier(pebble, random)}};
    for (const NamedShape& named : shapes)
    {
        const Rest rest = restOf(named.shape);
        EXPECT_LE(rest.weightError, weightBar) << named.name;
        EXPECT_LE(rest.drift, driftBar) << named.name;
        std::printf("%s: weight error %.2g, drift %.2g\n", named.name.c_str(), rest.weightError, rest.drift);
        weightError = std::max(weightError, rest.weightError);
        drift = std::max(drift, rest.drift);
    }
    test::record("firstLight", "restWeightError", weightError, "-");
    test::record("firstLight", "restDrift", drift, "-");
}

TEST(GrainAtRest, aTileRestsOnItsFlatSide)
{
    // Carried at both ends of its side: one foot point would jump from end to end with every tilt.
    WorldSettings settings = test::quartzSettings();
    settings.walls = {test::floorWall()};
    GrainState grain;
    grain.position = Vector2(0, 0.0201);
    grain.angle = 0.01;
    settings.grains = {grain};
    for (const NamedShape& tile :
         {NamedShape{"tile", test::rectangle(0.06, 0.04)}, NamedShape{"rounded tile", test::roundedSquare(0.04, 0.005)}})
    {
        settings.shapes = {tile};
        World world(settings);
        const double timeStep = 0.5 * world.stableTimeStep();
        const double weight = settings.materials[0].density * world.areaOf(0) * 9.81;
        world.updateForces();
        for (int i = 0; i < 200000; ++i)
        {
            world.step(timeStep);
        }
        EXPECT_LT(kineticEnergy(world.bodies()), 1e-20 * weight * world.sizeOf(0)) << tile.name;
        EXPECT_NEAR(world.bodies().pose[0].rotation.angle(), 0, 1e-12) << tile.name;
        EXPECT_NEAR(forceOfTheFloor(world).y() / weight, 1, weightBar) << tile.name;
        ASSERT_EQ(world.contacts().size(), 2u);
        EXPECT_NEAR(world.contacts()[0].force.y(), world.contacts()[1].force.y(), weightBar * weight);
    }
}
