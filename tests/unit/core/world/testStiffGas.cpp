#include "core/contact/restitution.hpp"

#include "unit/core/world/energyWatch.hpp"
#include "unit/core/world/worldScenes.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

// Gases of mixed grains in a closed box at stiffnesses over nine decades, at the automatic step. Speeds follow the
// root of the stiffness: overlaps of a thousandth of a grain, and some collisions of each grain, in any of them.

using namespace chesil;

namespace
{

constexpr double boxSide = 0.8;

WorldSettings gas(double stiffness, double friction, double restitution)
{
    WorldSettings settings = test::quartzSettings();
    settings.gravity = Vector2::Zero();
    settings.localDamping = 0;
    settings.energyLedger = true;
    settings.linear().normalStiffness = stiffness;
    settings.linear().tangentialStiffness = 0.8 * stiffness;
    settings.linear().friction = friction;
    settings.linear().dampingRatio = dampingRatioOf(restitution);
    settings.shapes = test::shapesOfEachKind(99);
    settings.grains = placeOnLattice(settings.shapes, {0, 1, 2, 3}, 100, {Vector2(0, 0), Vector2(boxSide, boxSide)}, 7);
    settings.walls = {
        test::floorWall(),
        {"left", Vector2(0, 0), Vector2(1, 0)},
        {"right", Vector2(boxSide, 0), Vector2(-1, 0)},
        {"lid", Vector2(0, boxSide), Vector2(0, -1)}};
    const double mass = 2650 * M_PI * 0.025 * 0.025;
    const double speed = 1e-3 * 0.05 * std::sqrt(stiffness / mass);
    test::RandomSource random(8);
    for (GrainState& grain : settings.grains)
    {
        grain.velocity = speed * random.uniform(0.5, 1.5) * random.direction();
        grain.angularVelocity = speed / 0.025 * random.uniform(-1, 1);
    }
    return settings;
}

test::EnergyWatch run(double stiffness, double friction, double restitution)
{
    World world(gas(stiffness, friction, restitution));
    const test::EnergyWatch watch = test::watchEnergy(world, 12000, 0.5, 5);
    EXPECT_EQ(watch.status, StepStatus::done);
    std::printf(
        "k %.0e N/m, friction %.1f, restitution %.1f: growth %.1e, residual %.1e, overlap %.1e, kinetic at the end %.3f\n", stiffness,
        friction, restitution, watch.growth, watch.residual, watch.largestOverlap, watch.lastKinetic);
    EXPECT_GT(watch.largestOverlap, 2e-4);
    return watch;
}

} // namespace

TEST(StiffGas, gainsNoEnergyWithoutLosses)
{
    double worst = 0;
    for (const double stiffness : {1e4, 1e7, 1e10, 1e13})
    {
        worst = std::max(worst, run(stiffness, 0, 1).growth);
    }
    EXPECT_LT(worst, 1e-3);
    test::record("dryEngine", "stiffGasGrowth", worst, "-");
}

TEST(StiffGas, gainsNoEnergyWithFriction)
{
    double worst = 0;
    for (const double stiffness : {1e4, 1e7, 1e10, 1e13})
    {
        for (const double restitution : {1.0, 0.5})
        {
            worst = std::max(worst, run(stiffness, 0.5, restitution).growth);
        }
    }
    EXPECT_LT(worst, 1e-3);
    test::record("dryEngine", "stiffFrictionalGasGrowth", worst, "-");
}
