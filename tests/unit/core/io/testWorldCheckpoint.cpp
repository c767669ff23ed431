#include "core/io/worldCheckpoint.hpp"

#include "core/base/setupError.hpp"
#include "unit/core/world/worldScenes.hpp"
#include "unit/temporaryFolder.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

class WorldCheckpoint : public test::TemporaryFolder
{
protected:
    std::string path() const { return folder_ + "/state"; }

    void save(const World& world) const
    {
        CheckpointWriter writer;
        addState(writer, world.state());
        writer.write(path());
    }

    WorldState load() const
    {
        CheckpointReader reader(path());
        WorldState state = takeState(reader);
        reader.finish();
        return state;
    }
};

/// Everything that carries something on.
WorldSettings richScene()
{
    WorldSettings settings = test::mixedScene(60, 9);
    settings.linear().dampingRatio = 0.1;
    settings.linear().rollingFriction = 0.1;
    settings.linear().cohesion = 0.1;
    settings.localDamping = 0.1;
    settings.viscousDamping = 0.1;
    settings.energyLedger = true;
    settings.walls[0].motion = DrivenWall{Vector2(0.01, 0), Vector2(0, 1e-3), 30};
    settings.walls[2].motion = ServoWall{100, 0.1, {0, 3}};
    settings.walls.push_back({"lid", Vector2(0, 2), Vector2(0, -1)});
    return settings;
}

void run(World& world, int steps, double timeStep)
{
    for (int step = 0; step < steps; ++step)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done);
    }
}

} // namespace

TEST_F(WorldCheckpoint, aRestartGoesOnToTheBit)
{
    const WorldSettings settings = richScene();
    World through(settings);
    through.updateForces();
    const double timeStep = through.stableTimeStep() / 2;
    for (int part = 0; part < 8; ++part)
    {
        run(through, 1500, timeStep);
        save(through);
        World resumed(settings);
        resumed.resume(load());
        EXPECT_EQ(test::hashOf(resumed), test::hashOf(through));
        World ahead = through;
        run(ahead, 700, timeStep);
        run(resumed, 700, timeStep);
        EXPECT_EQ(test::hashOf(resumed), test::hashOf(ahead)) << "part " << part;
        EXPECT_EQ(resumed.contactEnergy(), ahead.contactEnergy());
        EXPECT_EQ(resumed.energyLedger()->contacts, ahead.energyLedger()->contacts);
        EXPECT_EQ(resumed.energyLedger()->walls, ahead.energyLedger()->walls);
        EXPECT_EQ(resumed.walls()[2].point, ahead.walls()[2].point);
        EXPECT_EQ(resumed.time(), ahead.time());
        through = ahead;
    }
    EXPECT_GT(through.contactEnergy(), 0);
}

TEST_F(WorldCheckpoint, otherGrainsOrWallsAreRefused)
{
    const WorldSettings settings = richScene();
    World world(settings);
    run(world, 10, 1e-6);
    save(world);
    const auto refused = [&](const WorldSettings& other, const std::string& found)
    {
        World fresh(other);
        try
        {
            fresh.resume(load());
            FAIL() << "taken";
        }
        catch (const ValueError& error)
        {
            EXPECT_NE(std::string(error.what()).find(found), std::string::npos) << error.what();
        }
    };
    WorldSettings other = settings;
    other.grains.pop_back();
    refused(other, "60 grains");
    other = settings;
    other.walls.pop_back();
    refused(other, "walls");
    other = settings;
    other.materials[0].density *= 2;
    refused(other, "grain 0 of another mass");
}

TEST_F(WorldCheckpoint, frictionMayBeTurnedOnOrOff)
{
    WorldSettings settings = richScene();
    settings.linear().friction = 0;
    World smooth(settings);
    run(smooth, 4000, smooth.stableTimeStep() / 2);
    save(smooth);
    settings.linear().friction = 0.5;
    World rough(settings);
    rough.resume(load());
    run(rough, 100, rough.stableTimeStep() / 2);
    EXPECT_EQ(rough.springs().size(), rough.contacts().size());
}
