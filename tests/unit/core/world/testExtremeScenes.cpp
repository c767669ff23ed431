#include "core/contact/restitution.hpp"
#include "core/shapes/scaledShape.hpp"

#include "unit/core/world/energyWatch.hpp"
#include "unit/core/world/worldScenes.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

// Scenes at the ends of what users ask for. None may blow up, gain energy or lose the ledger's balance.

using namespace chesil;
using test::EnergyWatch;

namespace
{

constexpr double boxWidth = 0.6;

/// Shapes in a box, as many of each in turn; friction, some damping, the ledger kept.
WorldSettings heap(const std::vector<NamedShape>& shapes, int number, double friction)
{
    WorldSettings settings = test::quartzSettings();
    settings.localDamping = 0;
    settings.energyLedger = true;
    settings.linear().friction = friction;
    settings.linear().dampingRatio = dampingRatioOf(0.5);
    settings.shapes = shapes;
    std::vector<int> choice(shapes.size());
    for (std::size_t i = 0; i < choice.size(); ++i)
    {
        choice[i] = static_cast<int>(i);
    }
    settings.grains = placeOnLattice(shapes, choice, number, {Vector2(0, 0), Vector2(boxWidth, 20)}, 31);
    settings.walls = {
        test::floorWall(), {"left", Vector2(0, 0), Vector2(1, 0)}, {"right", Vector2(boxWidth, 0), Vector2(-1, 0)}};
    return settings;
}

void expectInside(const World& world)
{
    for (const Pose<2>& pose : world.bodies().pose)
    {
        EXPECT_GT(pose.position.x(), 0);
        EXPECT_LT(pose.position.x(), boxWidth);
        EXPECT_GT(pose.position.y(), 0);
    }
}

/// Runs on; a failure's name is told by `name`.
EnergyWatch checked(const char* name, World& world, int steps, int every = 4)
{
    const EnergyWatch watch = test::watchEnergy(world, steps, 0.5, every);
    std::printf(
        "%-36s %.2f s, growth %.1e, residual %.1e, overlap %.1e, kinetic at the end %.1e\n", name, world.time(), watch.growth,
        watch.residual, watch.largestOverlap, watch.lastKinetic);
    EXPECT_EQ(watch.status, StepStatus::done) << name << ": " << describe(watch.status, world.brokenGrain());
    EXPECT_EQ(world.doubtfulQueries(), 0u) << name;
    expectInside(world);
    return watch;
}

} // namespace

TEST(ExtremeScenes, frictionFromNoneToTen)
{
    double growth = 0;
    double residual = 0;
    for (const double friction : {0.0, 0.1, 0.5, 1.0, 3.0, 10.0})
    {
        World world(heap(test::shapesOfEachKind(5), 60, friction));
        const EnergyWatch watch = checked(("friction " + std::to_string(friction)).c_str(), world, 16000);
        growth = std::max(growth, watch.growth);
        residual = std::max(residual, watch.residual);
        EXPECT_LT(watch.lastKinetic, 0.02);
    }
    EXPECT_LT(growth, 1e-3);
    EXPECT_LT(residual, 3e-2);
    test::record("dryEngine", "extremeFrictionGrowth", growth, "-");
    test::record("dryEngine", "extremeFrictionResidual", residual, "-");
}

TEST(ExtremeScenes, sizesOneToAHundred)
{
    // One big grain and many small ones: it falls on them, and they on it.
    double growth = 0;
    double residual = 0;
    for (const bool bigOnTop : {true, false})
    {
        for (std::size_t kind = 0; kind < 4; ++kind)
        {
            const NamedShape big = test::shapesOfEachKind(6)[kind];
            std::vector<NamedShape> small;
            for (const NamedShape& named : test::shapesOfEachKind(6))
            {
                small.push_back({named.name, scaled(named.shape, 0.01)});
            }
            WorldSettings settings = heap(small, 1, 0.5);
            settings.shapes.push_back({"big", big.shape});
            const double top = support(big.shape, Vector2(0, 1)).y();
            const double bottom = -support(big.shape, Vector2(0, -1)).y();
            const double level = bigOnTop ? 0 : bottom + top;
            settings.grains = placeOnLattice(small, {0, 1, 2, 3}, 150, {Vector2(0.28, level), Vector2(0.32, level + 0.1)}, 4);
            double highest = 0;
            for (GrainState& grain : settings.grains)
            {
                highest = std::max(highest, grain.position.y());
                grain.velocity = Vector2(0, bigOnTop ? 0 : -0.5);
            }
            GrainState bigGrain;
            bigGrain.shape = 4;
            bigGrain.position = Vector2(0.3, bigOnTop ? highest + 0.0004 + bottom : 1.0001 * bottom);
            bigGrain.velocity = Vector2(0, bigOnTop ? -0.1 : 0);
            settings.grains.push_back(bigGrain);
            World world(settings);
            const EnergyWatch watch =
                checked((big.name + (bigOnTop ? " on" : " under") + " grains of 1/100").c_str(), world, 15000, 10);
            EXPECT_GT(watch.largestOverlap, 0) << big.name;
            growth = std::max(growth, watch.growth);
            residual = std::max(residual, watch.residual);
        }
    }
    EXPECT_LT(growth, 1e-3);
    EXPECT_LT(residual, 3e-2);
    test::record("dryEngine", "extremeSizesGrowth", growth, "-");
    test::record("dryEngine", "extremeSizesResidual", residual, "-");
}

TEST(ExtremeScenes, aspectRatioFifty)
{
    double growth = 0;
    double residual = 0;
    const std::vector<NamedShape> needles{
        {"ellipse", Ellipse(0.1, 0.002)},
        {"polygon", test::rectangle(0.2, 0.004)},
        {"polybezier", PolyBezier(test::ellipseSegments(12, 0.1, 0.002))}};
    for (const double friction : {0.0, 0.5})
    {
        for (const NamedShape& needle : needles)
        {
            // Ten times as stiff as the other heaps: needles are thin, and overlaps are a share of their width.
            WorldSettings settings = heap({needle}, 20, friction);
            settings.linear().normalStiffness = settings.linear().tangentialStiffness = 1e7;
            World world(settings);
            const EnergyWatch watch = checked((needle.name + " 1:50").c_str(), world, 60000, 10);
            growth = std::max(growth, watch.growth);
            residual = std::max(residual, watch.residual);
        }
    }
    EXPECT_LT(growth, 1e-3);
    EXPECT_LT(residual, 3e-2);
    test::record("dryEngine", "extremeNeedlesGrowth", growth, "-");
    test::record("dryEngine", "extremeNeedlesResidual", residual, "-");
}

TEST(ExtremeScenes, densitiesOverEightDecades)
{
    double growth = 0;
    double residual = 0;
    struct Case
    {
        double first, second;
    };
    for (const Case& c : {Case{1e-3, 1e-3}, Case{1, 1}, Case{1e5, 1e5}, Case{1e-3, 1e5}})
    {
        WorldSettings settings = heap(test::shapesOfEachKind(8), 40, 0.5);
        settings.materials = {{"first", c.first}, {"second", c.second}};
        LinearLaw law = settings.linear();
        // Of 1e6 N/m for quartz: the heavy grains' weight asks for more.
        law.normalStiffness = law.tangentialStiffness = 1e6 * c.second / 2650;
        LawTable<LinearLaw> laws(2);
        laws.set(0, 0, law);
        laws.set(0, 1, law);
        laws.set(1, 1, law);
        settings.contact = laws;
        for (std::size_t i = 0; i < settings.grains.size(); ++i)
        {
            // The light ones below, one heavy one in ten.
            settings.grains[i].material = i % 10 == 9 ? 1 : 0;
            if (c.first != c.second && i % 10 == 9)
            {
                // Ten thousand times the light ones' time: thrown, or it would not get anywhere in the run.
                settings.grains[i].velocity = Vector2(13, -20);
            }
        }
        World world(settings);
        const std::string name = "densities " + std::to_string(c.first) + " and " + std::to_string(c.second);
        const bool mixed = c.first != c.second;
        const EnergyWatch watch = checked(name.c_str(), world, mixed ? 300000 : 8000, mixed ? 7 : 4);
        EXPECT_GT(watch.largestOverlap, 0) << name;
        growth = std::max(growth, watch.growth);
        residual = std::max(residual, watch.residual);
    }
    EXPECT_LT(growth, 1e-3);
    EXPECT_LT(residual, 3e-2);
    test::record("dryEngine", "extremeDensitiesGrowth", growth, "-");
    test::record("dryEngine", "extremeDensitiesResidual", residual, "-");
}

TEST(ExtremeScenes, gravityTurnedRoundUnderASettledHeap)
{
    WorldSettings settings = heap(test::shapesOfEachKind(5), 60, 0.5);
    settings.walls.push_back({"lid", Vector2(0, 1.5), Vector2(0, -1)});
    World settled(settings);
    checked("before gravity turns", settled, 16000);
    double growth = 0;
    double residual = 0;
    for (const Vector2& gravity : {Vector2(0, 9.81), Vector2(9.81, 0), Vector2(0, 0), Vector2(0, -98.1)})
    {
        settings.gravity = gravity;
        World turned(settings);
        WorldState state = settled.state();
        state.ledger.reset();
        turned.resume(state);
        const EnergyWatch watch = checked("after", turned, 8000);
        growth = std::max(growth, watch.growth);
        residual = std::max(residual, watch.residual);
    }
    EXPECT_LT(growth, 1e-3);
    EXPECT_LT(residual, 3e-2);
    test::record("dryEngine", "turnedGravityGrowth", growth, "-");
    test::record("dryEngine", "turnedGravityResidual", residual, "-");
}
