#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

std::uint64_t hashAfter(const WorldSettings& settings, int steps)
{
    World world(settings);
    const double timeStep = 0.5 * world.stableTimeStep();
    world.updateForces();
    for (int i = 0; i < steps; ++i)
    {
        EXPECT_EQ(world.step(timeStep), StepStatus::done);
    }
    EXPECT_GT(world.largestRelativeOverlap(), 0);
    return test::hashOf(world);
}

} // namespace

TEST(Determinism, theSameInputGivesTheSameBits)
{
    const WorldSettings settings = test::mixedScene(60, 161);
    const std::uint64_t first = hashAfter(settings, 5000);
    EXPECT_EQ(first, hashAfter(settings, 5000));
    // The hash sees a single bit of a single grain.
    WorldSettings nudged = settings;
    nudged.grains[59].position.x() = std::nextafter(nudged.grains[59].position.x(), 1.0);
    EXPECT_NE(first, hashAfter(nudged, 5000));
}
