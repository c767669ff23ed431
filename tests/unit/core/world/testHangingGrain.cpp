#include "core/measure/energy.hpp"
#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>

using namespace chesil;

// A ball that sticks to a ceiling, or does not, by the work of adhesion of law hertzMindlin.

namespace
{

constexpr double weight = 2650 * M_PI * 0.05 * 0.05 * 9.81;

/// `share`: pull-off force over weight. The ball flies up into the ceiling.
WorldSettings underCeiling(double share)
{
    WorldSettings settings = test::freeBall();
    settings.gravity = Vector2(0, -9.81);
    settings.grains[0].position = Vector2(0, -0.0501);
    settings.grains[0].velocity = Vector2(0, 0.05);
    settings.walls = {{"ceiling", Vector2(0, 0), Vector2(0, -1)}};
    HertzMindlinLaw law;
    law.effectiveModulus = 1e8;
    law.effectiveShearModulus = 1e8;
    law.dampingRatio = 0.5;
    law.workOfAdhesion = share * weight / (2 * M_PI * 0.05);
    LawTable<HertzMindlinLaw> table;
    table.only() = law;
    settings.contact = table;
    settings.energyLedger = true;
    return settings;
}

World afterASecond(const WorldSettings& settings)
{
    World world(settings);
    world.updateForces();
    const double timeStep = world.stableTimeStep() / 5;
    while (world.time() < 1)
    {
        EXPECT_EQ(world.step(timeStep), StepStatus::done);
    }
    return world;
}

} // namespace

TEST(HangingGrain, staysIfThePullOffForceBearsIt)
{
    const World world = afterASecond(underCeiling(1.05));
    ASSERT_EQ(world.contacts().size(), 1u);
    const double depth = world.contacts()[0].depth;
    // (4/3) E sqrt(R) d^(3/2) is what the pull-off force has left.
    EXPECT_NEAR(4.0 / 3.0 * 1e8 * std::sqrt(0.05) * std::pow(depth, 1.5) / (0.05 * weight), 1, 1e-6);
    EXPECT_LT(kineticEnergy(world.bodies()), 1e-12);
}

TEST(HangingGrain, fallsIfItDoesNot)
{
    const World world = afterASecond(underCeiling(0.95));
    EXPECT_LT(world.bodies().pose[0].position.y(), -1);
}

TEST(HangingGrain, theLedgerClosesWithTheAttraction)
{
    const World world = afterASecond(underCeiling(1.05));
    const EnergyLedger& ledger = *world.energyLedger();
    EXPECT_LT(world.contactEnergy(), 0);
    EXPECT_GT(ledger.contacts, 0);
    EXPECT_LT(std::abs(ledger.residual(kineticEnergy(world.bodies()), world.contactEnergy())),
              1e-3 * ledger.contacts);
}

TEST(HangingGrain, theAttractionsBeginningAndEndAreOfSecondOrder)
{
    // A ball that loses nothing leaves the ceiling again. Where in its step it touches must not matter: the
    // work of the attraction over half a step's way would be of first order.
    const auto worst = [](double share)
    {
        double largest = 0;
        for (int i = 0; i < 20; ++i)
        {
            WorldSettings settings = underCeiling(1.05);
            std::get<LawTable<HertzMindlinLaw>>(settings.contact).only().dampingRatio = 0;
            settings.grains[0].position.y() -= 1e-6 * i;
            World world(settings);
            world.updateForces();
            const double timeStep = share * world.stableTimeStep();
            while (world.time() < 0.3)
            {
                EXPECT_EQ(world.step(timeStep), StepStatus::done);
            }
            EXPECT_EQ(world.contactEnergy(), 0);
            largest =
                std::max(largest, std::abs(world.energyLedger()->residual(kineticEnergy(world.bodies()), 0)));
        }
        return largest;
    };
    const double coarse = worst(0.1);
    const double fine = worst(0.025);
    std::printf("residual %.3g J at 0.1 of the stable step, %.3g J at 0.025: order %.2f\n", coarse, fine,
                std::log2(coarse / fine) / 2);
    EXPECT_GT(coarse / fine, 11) << "order 1.7 or more";
}
