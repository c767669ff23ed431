#include "core/base/setupError.hpp"
#include "core/measure/energy.hpp"
#include "core/measure/stress.hpp"
#include "core/world/world.hpp"

#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

using namespace chesil;

// Worlds in a periodic cell, at rest or strained.

namespace
{

constexpr double side = 0.6;

StrainedCell squareCell(const Eigen::Matrix2d& gradient = Eigen::Matrix2d::Zero())
{
    return StrainedCell(PeriodicCell(Vector2(0, 0), Vector2(side, 0), Vector2(0, side)), gradient);
}

Eigen::Matrix2d shearing(double rate)
{
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
    gradient(0, 1) = rate;
    return gradient;
}

/// Disks and ellipses that fly about in a cell, elastic and frictionless unless told otherwise.
WorldSettings gasInCell(const StrainedCell& cell, double speed, std::uint64_t seed)
{
    WorldSettings settings = test::quartzSettings();
    settings.gravity = Vector2::Zero();
    settings.localDamping = 0;
    settings.linear().friction = 0;
    settings.shapes = test::shapesOfEachKind(seed);
    settings.grains = placeOnLattice(settings.shapes, {0, 1}, 60, {Vector2(0, 0), Vector2(side, side)}, seed);
    settings.cell = cell;
    test::RandomSource random(seed);
    for (GrainState& grain : settings.grains)
    {
        grain.velocity = speed * random.direction();
        grain.angularVelocity = random.uniform(-1, 1) * speed / 0.025;
    }
    return settings;
}

void run(World& world, double timeStep, int steps)
{
    for (int i = 0; i < steps; ++i)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done) << "step " << i;
    }
}

Vector2 momentumOf(const World& world)
{
    Vector2 sum = Vector2::Zero();
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
        sum += world.bodies().velocity[i] / world.bodies().inverseMass[i];
    }
    return sum;
}

} // namespace

TEST(StrainedCell, aGrainThatLeavesComesInFromTheOtherSide)
{
    WorldSettings settings = test::freeBall();
    settings.grains[0].position = Vector2(0.5, 0.3);
    settings.grains[0].velocity = Vector2(1, -2);
    settings.cell = squareCell();
    World world(settings);
    world.updateForces();
    run(world, 1e-3, 1000);
    Vector2 expected(0.5 + 1, 0.3 - 2);
    squareCell().cell.wrap(expected);
    Vector2 found = world.bodies().pose[0].position;
    squareCell().cell.wrap(found);
    EXPECT_LT((found - expected).norm(), 1e-12);
    EXPECT_LT((world.bodies().pose[0].position - expected).cwiseAbs().maxCoeff(), side + 0.05) << "it was wrapped";
    EXPECT_EQ(world.bodies().velocity[0], Vector2(1, -2));
}

TEST(StrainedCell, whereTheCellBeginsDoesNotMatter)
{
    // The same gas, cut by the boundary elsewhere: equal until rounding has grown.
    const WorldSettings settings = gasInCell(squareCell(), 1, 11);
    WorldSettings shifted = settings;
    shifted.cell.emplace(PeriodicCell(Vector2(0.21, -0.37), Vector2(side, 0), Vector2(0, side)));
    World one(settings);
    World other(shifted);
    one.updateForces();
    other.updateForces();
    const double timeStep = one.stableTimeStep() / 4;
    std::size_t across = 0;
    for (int i = 0; i < 1500; ++i)
    {
        ASSERT_EQ(one.step(timeStep), StepStatus::done);
        ASSERT_EQ(other.step(timeStep), StepStatus::done);
        for (const Contact<2>& contact : one.contacts())
        {
            across += contact.depth > 0 && !(contact.shift == NearShift{});
        }
    }
    double worst = 0;
    for (std::size_t i = 0; i < one.bodies().size(); ++i)
    {
        const Vector2 between = other.bodies().pose[i].position - one.bodies().pose[i].position;
        const PeriodicCell& cell = one.cell()->cell;
        worst = std::max(worst, (between + cell.offset(cell.nearestShift(between))).norm());
    }
    EXPECT_GT(across, 0u) << "pairs meet across the boundary";
    EXPECT_LT(worst, 1e-8);
}

TEST(StrainedCell, keepsMomentumAndEnergyAtRest)
{
    World world(gasInCell(squareCell(), 1, 12));
    world.updateForces();
    const Vector2 momentum = momentumOf(world);
    const double energy = kineticEnergy(world.bodies()) + world.contactEnergy();
    run(world, world.stableTimeStep() / 10, 20000);
    EXPECT_LT((momentumOf(world) - momentum).norm(), 1e-11 * momentum.norm());
    EXPECT_NEAR((kineticEnergy(world.bodies()) + world.contactEnergy()) / energy, 1, 3e-4);
}

TEST(StrainedCell, anImageMovesFasterByTheFlow)
{
    // Crossing the upper side of a sheared cell changes the velocity by that of the image.
    WorldSettings settings = test::freeBall();
    settings.grains[0].position = Vector2(0.3, 0.5);
    settings.grains[0].velocity = Vector2(0, 1);
    settings.cell = squareCell(shearing(2));
    World world(settings);
    world.updateForces();
    EXPECT_LT((world.bodies().velocity[0] - Vector2(2 * 0.5, 1)).norm(), 1e-15) << "the flow is added at the start";
    run(world, 1e-3, 200);
    EXPECT_GT(0.65, world.bodies().pose[0].position.y());
    EXPECT_NEAR(world.bodies().velocity[0].x(), 2 * 0.5 - 2 * side, 1e-12) << "it came in below";
    EXPECT_NEAR(world.bodies().velocity[0].y(), 1, 1e-15);
}

TEST(StrainedCell, aShearedCellStaysUpright)
{
    StrainedCell cell = squareCell(shearing(1));
    for (int i = 0; i < 300; ++i)
    {
        cell.strain(0.01);
        cell.straighten();
        EXPECT_LE(std::abs(cell.cell.second().x()), side * 0.5000001);
    }
    EXPECT_NEAR(cell.cell.second().x(), 3 * side - std::round(3.0) * side, 1e-12) << "a strain of 3 is the same lattice";
    EXPECT_NEAR(cell.cell.second().y(), side, 1e-15);
}

TEST(StrainedCell, theLedgerClosesAndStrainWorksAsTheStressSays)
{
    // Frictionless, so that what the images do is all: d(energy)/dt = -area sigma : L, kinetic part of the stress included.
    Eigen::Matrix2d gradient;
    gradient << -0.5, 0.8, 0.3, -0.4;
    WorldSettings settings = gasInCell(squareCell(gradient), 1, 13);
    settings.energyLedger = true;
    World world(settings);
    world.updateForces();
    const double timeStep = world.stableTimeStep() / 20;
    double worst = 0;
    for (int i = 0; i < 10000; ++i)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done);
        const EnergyLedger& ledger = *world.energyLedger();
        worst = std::max(worst, std::abs(ledger.residual(kineticEnergy(world.bodies()), world.contactEnergy())) / ledger.start);
    }
    EXPECT_GT(std::abs(world.energyLedger()->walls), 0.05 * world.energyLedger()->start) << "the strain works";
    EXPECT_LT(worst, 1e-3);
}

TEST(StrainedCell, theForcePartOfTheWorkIsThatOfTheStress)
{
    // Compressed slowly, so that inertia hardly counts beside the contacts' stress.
    Eigen::Matrix2d gradient;
    gradient << -0.1, 0.05, 0, -0.15;
    WorldSettings settings = gasInCell(squareCell(gradient), 0, 14);
    settings.linear().dampingRatio = 0.5;
    settings.energyLedger = true;
    World world(settings);
    world.updateForces();
    const double timeStep = world.stableTimeStep() / 2;
    double byStress = 0;
    double before = 0;
    while (world.time() < 4.15)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done);
        if (world.time() < 4.1)
        {
            before = world.energyLedger()->walls;
            continue;
        }
        const PeriodicCell& cell = world.cell()->cell;
        const double area = cross(cell.first(), cell.second());
        const Eigen::Matrix2d stress =
            meanStress(world.contacts(), [&](const Contact<2>& contact) { return world.branchOf(contact); }, area);
        byStress -= timeStep * area * (gradient * stress).trace();
    }
    EXPECT_GT(byStress, 0);
    EXPECT_NEAR((world.energyLedger()->walls - before) / byStress, 1, 0.01);
    std::printf("work %g by stress %g, overlap %g\n", world.energyLedger()->walls - before, byStress, world.largestRelativeOverlap());
}

TEST(StrainedCell, goesOnToTheBit)
{
    WorldSettings settings = gasInCell(squareCell(shearing(1)), 1, 15);
    settings.linear().friction = 0.4;
    World whole(settings);
    whole.updateForces();
    const double timeStep = whole.stableTimeStep() / 2;
    run(whole, timeStep, 1500);
    World later(settings);
    later.resume(whole.state());
    run(whole, timeStep, 1500);
    run(later, timeStep, 1500);
    EXPECT_EQ(test::hashOf(whole), test::hashOf(later));
}

TEST(StrainedCell, thatHasBecomeTooNarrowEndsTheStep)
{
    // Compressed across until two images of a pair could meet: a status, no exception.
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
    gradient(0, 0) = -1;
    WorldSettings settings = test::freeBall();
    settings.cell = squareCell(gradient);
    settings.grains[0].position = Vector2(0.2, 0.3);
    World world(settings);
    world.updateForces();
    StepStatus status = StepStatus::done;
    for (int i = 0; i < 2000 && status == StepStatus::done; ++i)
    {
        ASSERT_NO_THROW(status = world.step(1e-3)) << world.time();
    }
    EXPECT_EQ(status, StepStatus::tooNarrow);
    EXPECT_NEAR(world.time(), std::log(side / 0.2), 0.2) << "four radii, and the margin";
    EXPECT_GT(world.cell()->cell.widths().minCoeff(), 0.2);
    EXPECT_NE(describe(status, 0).find("has become narrower than two of its biggest grains reach"), std::string::npos);
}

TEST(StrainedCell, refusesWhatHasNoMeaning)
{
    EXPECT_THROW(StrainedCell(PeriodicCell(Vector2(0, 0), Vector2(1, 0), Vector2(0, 0)), shearing(1)), ValueError);
    EXPECT_THROW(squareCell(shearing(std::nan(""))), ValueError);
    WorldSettings narrow = test::freeBall();
    narrow.cell.emplace(PeriodicCell(Vector2(0, 0), Vector2(0.2, 0), Vector2(0, 0.2)));
    World world(narrow);
    EXPECT_THROW(world.updateForces(), ValueError);
}
