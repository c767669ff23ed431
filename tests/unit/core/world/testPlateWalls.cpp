#include "core/base/setupError.hpp"
#include "core/boundary/plateWall.hpp"
#include "core/measure/energy.hpp"
#include "core/world/world.hpp"

#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

using namespace chesil;

// Walls that end: grains rest on them, hit them from both sides and at their ends, and pass beside.

namespace
{

void run(World& world, double until)
{
    world.updateForces();
    const double timeStep = world.stableTimeStep() / 4;
    while (world.time() < until)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done);
    }
}

/// A ball of radius 0.05 m, elastic, at `position` with `velocity`, and a plate from (-1, 0) to (1, 0), 1 mm thick.
WorldSettings ballAndPlate(const Vector2& position, const Vector2& velocity)
{
    WorldSettings settings = test::freeBall();
    settings.linear().friction = 0;
    settings.grains[0].position = position;
    settings.grains[0].velocity = velocity;
    settings.walls = {plateWall("shelf", Vector2(-1, 0), Vector2(1, 0), 1e-3)};
    return settings;
}

} // namespace

TEST(PlateWalls, areMetFromBothSides)
{
    for (const double side : {-1.0, 1.0})
    {
        World world(ballAndPlate(Vector2(0.3, 0.1 * side), Vector2(0, -1 * side)));
        run(world, 0.2);
        EXPECT_NEAR(world.bodies().velocity[0].y(), side, 1e-3);
        EXPECT_NEAR(world.bodies().velocity[0].x(), 0, 1e-12);
    }
}

TEST(PlateWalls, letPassWhatGoesBeside)
{
    World world(ballAndPlate(Vector2(1.0501, 0.2), Vector2(0, -1)));
    run(world, 0.4);
    EXPECT_EQ(world.bodies().velocity[0], Vector2(0, -1));
}

TEST(PlateWalls, throwBackAtTheirEnds)
{
    // Onto the end along the plate: straight back. Onto the end askew: as a ball off a point, along the line of centres.
    World along(ballAndPlate(Vector2(1.2, 0), Vector2(-1, 0)));
    run(along, 0.4);
    EXPECT_NEAR(along.bodies().velocity[0].x(), 1, 1e-3);
    EXPECT_NEAR(along.bodies().velocity[0].y(), 0, 1e-10);

    const double offset = 0.03;
    World askew(ballAndPlate(Vector2(1 + offset, 0.05), Vector2(0, -0.01)));
    run(askew, 4);
    const Vector2 normal(offset / 0.05, std::sqrt(1 - offset * offset / 0.0025));
    const Vector2 expected = 0.01 * (Vector2(0, -1) + 2 * normal.y() * normal);
    EXPECT_LT((askew.bodies().velocity[0] - expected).norm(), 0.02 * 0.01) << "but for the depth and the thickness";
    EXPECT_NEAR(askew.bodies().velocity[0].norm(), 0.01, 1e-5);
}

TEST(PlateWalls, carryABlockThatHangsOver)
{
    WorldSettings settings = test::quartzSettings();
    settings.shapes = {{"block", ConvexPolygon({{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}})}};
    GrainState block;
    settings.walls = {plateWall("shelf", Vector2(-1, 0), Vector2(0, 0), 0.01)};
    for (const bool stays : {true, false})
    {
        block.position = Vector2(stays ? -0.02 : 0.02, 0.105);
        settings.grains = {block};
        World world(settings);
        run(world, 1.5);
        EXPECT_EQ(std::abs(world.bodies().pose[0].rotation.angle()) < 0.01, stays);
        EXPECT_EQ(world.bodies().pose[0].position.y() > 0.1, stays);
    }
}

TEST(PlateWalls, moveByLaw)
{
    WorldSettings settings = ballAndPlate(Vector2(0, 0.2), Vector2(0, 0));
    settings.walls[0].motion = DrivenWall{Vector2(0, 1), Vector2::Zero(), 0};
    World world(settings);
    run(world, 0.4);
    EXPECT_NEAR(world.bodies().velocity[0].y(), 2, 1e-3) << "off a moving wall at twice its speed";
}

TEST(PlateWalls, keepTheEnergyOfAGas)
{
    WorldSettings settings = test::mixedScene(40, 31);
    settings.gravity = Vector2::Zero();
    settings.localDamping = 0;
    settings.linear().friction = 0;
    for (GrainState& grain : settings.grains)
    {
        grain.shape = grain.shape % 2;
    }
    settings.walls.push_back({"lid", Vector2(0, 2), Vector2(0, -1)});
    for (int i = 0; i < 4; ++i)
    {
        const double y = 0.35 + 0.4 * i;
        settings.walls.push_back(plateWall("plate" + std::to_string(i), Vector2(0.25, y), Vector2(0.4, y + 0.02), 2e-3));
    }
    test::RandomSource random(31);
    for (GrainState& grain : settings.grains)
    {
        grain.velocity = random.direction();
    }
    // Those that a plate would cut are left out.
    const auto isCut = [&](const GrainState& grain)
    {
        return std::any_of(settings.walls.begin() + 4, settings.walls.end(),
                           [&](const PlaneWall<2>& wall) { return nearestTo(wall, grain.position) < 0.035; });
    };
    settings.grains.erase(std::remove_if(settings.grains.begin(), settings.grains.end(), isCut), settings.grains.end());
    ASSERT_GT(settings.grains.size(), 25u);
    World world(settings);
    world.updateForces();
    const double energy = kineticEnergy(world.bodies());
    const double timeStep = world.stableTimeStep() / 20;
    std::size_t plateContacts = 0;
    for (int i = 0; i < 60000; ++i)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done);
        for (const Contact<2>& contact : world.contacts())
        {
            plateContacts += contact.withWall() && contact.wall() > 3 && contact.depth > 0;
        }
    }
    EXPECT_GT(plateContacts, 1000u);
    EXPECT_NEAR((kineticEnergy(world.bodies()) + world.contactEnergy()) / energy, 1, 1e-4);
}

TEST(PlateWalls, refuseToHaveNoLengthOrThickness)
{
    EXPECT_THROW(plateWall("a", Vector2(1, 1), Vector2(1, 1), 1), ValueError);
    EXPECT_THROW(plateWall("a", Vector2(1, 1), Vector2(1, std::nan("")), 1), ValueError);
    EXPECT_THROW(plateWall("a", Vector2(0, 0), Vector2(1, 1), 0), ValueError);
}
