#include "core/base/setupError.hpp"
#include "core/measure/energy.hpp"
#include "core/measure/stress.hpp"
#include "core/world/loading.hpp"

#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace chesil;

// Isotropic and biaxial compression and simple shear of a small packing of all kinds of grains.

namespace
{

constexpr double pressure = 1e4;
constexpr double speed = 0.5;
const PlacementBox box{Vector2(0.1, -0.2), Vector2(0.7, 0.4)};

/// Between walls without friction, if they have material 1: a rough wall beside carries a part of the stress,
/// so that the stress of all contacts is not the pressure on the walls across.
WorldSettings sample()
{
    WorldSettings settings = test::quartzSettings();
    settings.gravity = Vector2::Zero();
    LinearLaw law = settings.linear();
    law.dampingRatio = 0.3;
    LinearLaw smooth = law;
    smooth.friction = 0;
    LawTable<LinearLaw> laws(2);
    laws.set(0, 0, law);
    laws.set(0, 1, smooth);
    laws.set(1, 1, smooth);
    settings.contact = laws;
    settings.materials.push_back({"smooth", 2650});
    settings.shapes = test::shapesOfEachKind(51);
    settings.grains = placeOnLattice(settings.shapes, {0, 1, 2, 3}, 70, box, 51);
    return settings;
}

std::vector<PlaneWall<2>> smooth(std::vector<PlaneWall<2>> walls)
{
    for (PlaneWall<2>& wall : walls)
    {
        wall.material = 1;
    }
    return walls;
}

void run(World& world, double duration)
{
    const double end = world.time() + duration;
    const double timeStep = world.stableTimeStep() / 2;
    while (world.time() < end)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done);
    }
}

double widthOf(const World& world) { return world.walls()[1].point.x() - world.walls()[0].point.x(); }
double heightOf(const World& world) { return world.walls()[3].point.y() - world.walls()[2].point.y(); }

/// Of a wall, over its length [Pa].
double pressureOn(const World& world, std::size_t wall)
{
    const double length = wall < 2 ? heightOf(world) : widthOf(world);
    return wallStress(world.wallStates()[wall].force, world.walls()[wall].normal, length).normal;
}

Eigen::Matrix2d stressByContacts(const World& world)
{
    const auto branch = [&](const Contact<2>& contact) { return world.branchOf(contact); };
    return meanStress(world.contacts(), branch, widthOf(world) * heightOf(world));
}

/// Compressed until at rest.
World compressed()
{
    WorldSettings settings = sample();
    settings.walls = smooth(isotropicCompression(box, pressure, speed));
    World world(settings);
    world.updateForces();
    run(world, 1.5);
    return world;
}

} // namespace

TEST(Loading, isotropicCompressionReachesItsPressureOnAllSides)
{
    const World world = compressed();
    EXPECT_LT(kineticEnergy(world.bodies()), 1e-4 * world.contactEnergy()) << "at rest";
    EXPECT_LT(widthOf(world), 0.6);
    for (std::size_t wall = 0; wall < 4; ++wall)
    {
        EXPECT_NEAR(pressureOn(world, wall) / pressure, 1, 0.01) << world.walls()[wall].name;
    }
    const Eigen::Matrix2d stress = stressByContacts(world);
    EXPECT_NEAR(stress(0, 0) / pressureOn(world, 0), 1, 0.01);
    EXPECT_NEAR(stress(1, 1) / pressureOn(world, 2), 1, 0.01);
    std::printf("stress %g %g, on the walls %g %g %g %g, box %g by %g\n", stress(0, 0), stress(1, 1),
                pressureOn(world, 0), pressureOn(world, 1), pressureOn(world, 2), pressureOn(world, 3),
                widthOf(world), heightOf(world));
}

TEST(Loading, biaxialCompressionGoesOnFromIsotropic)
{
    const World before = compressed();
    constexpr double rate = 0.01;
    WorldSettings settings = sample();
    settings.walls = smooth(biaxialCompression(box, pressure, speed, rate));
    World world(settings);
    world.resume(before.state());
    const double height = heightOf(before);
    EXPECT_EQ(heightOf(world), height);
    double byContacts = 0;
    double byWalls = 0;
    double confining = 0;
    int samples = 0;
    while (world.time() - before.time() < 1.5)
    {
        run(world, 0.002);
        const double elapsed = world.time() - before.time();
        ASSERT_NEAR(std::log(height / heightOf(world)) / (rate * elapsed), 1, 1e-9)
            << "axial strain as driven";
        if (elapsed > 0.7)
        {
            byContacts += stressByContacts(world)(1, 1);
            byWalls += (pressureOn(world, 2) + pressureOn(world, 3)) / 2;
            confining += (pressureOn(world, 0) + pressureOn(world, 1)) / 2;
            ++samples;
        }
    }
    EXPECT_NEAR(byContacts / byWalls, 1, 0.01);
    EXPECT_NEAR(confining / samples / pressure, 1, 0.01);
    EXPECT_GT(byWalls, 1.1 * confining) << "the sample resists";
    std::printf("axial %g by contacts, %g by walls, confining %g\n", byContacts / samples, byWalls / samples,
                confining / samples);
}

TEST(Loading, aNegativeStrainRateParts)
{
    WorldSettings settings = sample();
    settings.walls = biaxialCompression(box, pressure, speed, -2);
    settings.grains.resize(1);
    World world(settings);
    for (int i = 0; i < 100; ++i)
    {
        ASSERT_EQ(world.step(1e-3), StepStatus::done);
    }
    EXPECT_NEAR(heightOf(world), 0.6 * std::exp(0.2), 1e-12);
    EXPECT_NEAR(world.walls()[2].point.y() + world.walls()[3].point.y(), 0.2, 1e-12) << "about the middle";
}

TEST(Loading, simpleShearIsACellThatTilts)
{
    const StrainedCell cell = simpleShear(box, 0.7);
    EXPECT_EQ(cell.cell.lower(), box.lower);
    EXPECT_EQ(cell.cell.first() + cell.cell.second(), Vector2(box.upper - box.lower));
    EXPECT_EQ(cell.flow(box.upper), Vector2(0.7 * (box.upper - box.lower).y(), 0));

    WorldSettings settings = sample();
    settings.cell = cell;
    World world(settings);
    world.updateForces();
    run(world, 1);
    const double tilt = world.cell()->cell.second().x() / (box.upper - box.lower).y();
    EXPECT_NEAR(tilt - std::round(tilt), 0.7 * world.time() - std::round(0.7 * world.time()), 1e-9);
}

TEST(Loading, refusesWhatHasNoMeaning)
{
    const double endless = std::numeric_limits<double>::infinity();
    EXPECT_THROW(isotropicCompression({box.upper, box.lower}, pressure, speed), ValueError);
    for (const double wrong : {0.0, -1.0, endless, std::nan("")})
    {
        EXPECT_THROW(isotropicCompression(box, wrong, speed), ValueError);
        EXPECT_THROW(isotropicCompression(box, pressure, wrong), ValueError);
        EXPECT_THROW(biaxialCompression(box, wrong, speed, 1), ValueError);
        EXPECT_THROW(biaxialCompression(box, pressure, wrong, 1), ValueError);
    }
    EXPECT_THROW(biaxialCompression(box, pressure, speed, endless), ValueError);
    EXPECT_THROW(simpleShear(box, endless), ValueError);
    EXPECT_THROW(simpleShear({box.upper, box.lower}, 1), ValueError);
}
