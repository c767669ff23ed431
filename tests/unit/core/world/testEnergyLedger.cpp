#include "core/contact/restitution.hpp"
#include "core/measure/energy.hpp"
#include "core/world/world.hpp"

#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

/// Largest residual on the way over what gravity, walls and the start have brought in at the end.
double residualShare(WorldSettings settings, double duration, double shareOfStable)
{
    settings.energyLedger = true;
    World world(settings);
    world.updateForces();
    const double timeStep = shareOfStable * world.stableTimeStep();
    double worst = 0;
    while (world.time() < duration)
    {
        if (world.step(timeStep) != StepStatus::done)
        {
            ADD_FAILURE() << "at " << world.time() << " s";
            return 1;
        }
        const EnergyLedger& ledger = *world.energyLedger();
        const double residual = ledger.residual(kineticEnergy(world.bodies()), world.contactEnergy());
        worst = std::max(worst, std::abs(residual));
    }
    const EnergyLedger& ledger = *world.energyLedger();
    worst /= ledger.start + std::abs(ledger.works());
    std::printf("residual %.1e of the energy put in; gravity %.3g, walls %.3g, contacts -%.3g, local -%.3g, viscous -%.3g J\n",
                worst, ledger.gravity, ledger.walls, ledger.contacts, ledger.localDamping, ledger.viscousDamping);
    return worst;
}

} // namespace

TEST(EnergyLedger, isKeptOnlyIfAskedFor)
{
    World world(test::mixedScene(10, 3));
    world.step(1e-6);
    EXPECT_EQ(world.energyLedger(), nullptr);
}

TEST(EnergyLedger, closesWithTheTimeStepWhateverTakesEnergy)
{
    // Outlines without corners, so that the energy is a smooth function of the poses.
    WorldSettings settling = test::mixedScene(40, 3);
    for (GrainState& grain : settling.grains)
    {
        while (!isSmooth(settling.shapes[static_cast<std::size_t>(grain.shape)].shape))
        {
            grain.shape = (grain.shape + 1) % static_cast<int>(settling.shapes.size());
        }
    }
    struct Case
    {
        const char* name;
        double restitution, friction, rolling, local, viscous;
    };
    for (const Case& c : {Case{"elastic", 1, 0, 0, 0, 0},
                          Case{"dashpots", 0.3, 0, 0, 0, 0},
                          Case{"friction", 1, 0.5, 0, 0, 0},
                          Case{"rolling", 1, 0.5, 0.2, 0, 0},
                          Case{"local", 1, 0, 0, 0.7, 0},
                          Case{"viscous", 1, 0, 0, 0, 5},
                          Case{"all", 0.5, 0.5, 0.2, 0.3, 2}})
    {
        std::printf("%-9s ", c.name);
        WorldSettings settings = settling;
        settings.linear().dampingRatio = dampingRatioOf(c.restitution);
        settings.linear().friction = c.friction;
        settings.linear().rollingFriction = c.rolling;
        settings.localDamping = c.local;
        settings.viscousDamping = c.viscous;
        const double coarse = residualShare(settings, 0.3, 0.1);
        std::printf("%-9s ", "");
        const double fine = residualShare(settings, 0.3, 0.025);
        EXPECT_LT(coarse, 2e-2) << c.name;
        EXPECT_LT(fine, 0.5 * coarse) << c.name;
    }
}

TEST(EnergyLedger, knowsTheEnergyOfCohesion)
{
    // A disk that bounces on a sticky floor. Cohesion begins at once, which costs a step's way each time.
    WorldSettings settings = test::freeBall();
    settings.gravity = Vector2(0, -9.81);
    settings.walls = {test::floorWall()};
    settings.grains[0].position = Vector2(0, 0.06);
    settings.linear().cohesion = 0.1 * 2650 * M_PI * 0.05 * 0.05 * 9.81;
    settings.linear().friction = 0;
    settings.linear().dampingRatio = 0;
    EXPECT_LT(residualShare(settings, 0.5, 0.1), 5e-3);
    EXPECT_LT(residualShare(settings, 0.5, 0.01), 5e-4);
}

TEST(EnergyLedger, closesForHertzAndMindlinToo)
{
    // Of disks: where the radius of curvature changes as grains roll, Hertz's force has no potential.
    WorldSettings settings = test::freeBall();
    settings.gravity = Vector2(0, -9.81);
    settings.shapes.push_back({"small", Circle(0.03)});
    settings.walls = {test::floorWall(), {"left", Vector2(0, 0), Vector2(1, 0)}, {"right", Vector2(0.4, 0), Vector2(-1, 0)}};
    settings.grains = placeOnLattice(settings.shapes, {0, 1}, 12, {Vector2(0, 0), Vector2(0.4, 1)}, 5);
    LawTable<HertzMindlinLaw> laws;
    const ElasticMaterial soft{1e9, 0.3};
    laws.only().effectiveModulus = effectiveModulusOf(soft, soft);
    laws.only().effectiveShearModulus = effectiveShearModulusOf(soft, soft);
    laws.only().friction = 0.5;
    laws.only().dampingRatio = dampingRatioOf(0.8);
    settings.contact = laws;
    const double coarse = residualShare(settings, 0.5, 0.1);
    const double fine = residualShare(settings, 0.5, 0.025);
    EXPECT_LT(coarse, 5e-3);
    EXPECT_LT(fine, 0.5 * coarse);
}
