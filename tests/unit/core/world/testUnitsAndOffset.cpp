#include "core/contact/restitution.hpp"

#include "unit/core/world/worldScenes.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

// What a scene's units and its place must not change.
//
// Similarity: with all lengths times s, and density and gravity as they are, masses per depth go with s^2, weights with
// s^2, and an overlap of the same share of a grain asks for a stiffness per depth that goes with s. Times then go with
// sqrt(m/k) = sqrt(s), speeds with sqrt(s), spins with 1/sqrt(s). With s = 2^-20 every factor is a power of two, and
// so is each square root's. An engine without a length of its own gives the same digits.

using namespace chesil;

namespace
{

std::vector<NamedShape> shapesTimes(double scale)
{
    const std::vector<Vector2> tile{
        scale * Vector2(-0.025, -0.02), scale * Vector2(0.025, -0.02), scale * Vector2(0.01, 0.03), scale * Vector2(-0.02, 0.02)};
    return {
        {"ball", Circle(scale * 0.025)},
        {"egg", Ellipse(scale * 0.03, scale * 0.02)},
        {"tile", ConvexPolygon(tile)},
        {"pebble", PolyBezier(test::ellipseSegments(8, scale * 0.03, scale * 0.024))}};
}

/// 40 grains of all kinds that fall into a box with friction, rolling resistance and dashpots.
WorldSettings scene(double scale)
{
    WorldSettings settings = test::quartzSettings();
    settings.shapes = shapesTimes(1);
    settings.localDamping = 0;
    settings.linear().friction = 0.4;
    settings.linear().rollingFriction = 0.05;
    settings.linear().dampingRatio = 0.125;
    settings.grains = placeOnLattice(settings.shapes, {0, 1, 2, 3}, 40, {Vector2(0, 0), Vector2(0.5, 2)}, 12);
    settings.walls = {
        test::floorWall(), {"left", Vector2(0, 0), Vector2(1, 0)}, {"right", Vector2(scale * 0.5, 0), Vector2(-1, 0)}};
    settings.shapes = shapesTimes(scale);
    settings.linear().normalStiffness *= scale;
    settings.linear().tangentialStiffness *= scale;
    test::RandomSource random(3);
    for (GrainState& grain : settings.grains)
    {
        grain.position *= scale;
        grain.velocity = std::sqrt(scale) * random.direction();
    }
    return settings;
}

void run(World& world, double timeStep, int steps)
{
    world.updateForces();
    for (int i = 0; i < steps; ++i)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done);
    }
}

/// Largest difference of positions, apart from the offset, over the ball's radius; angles as they are.
double worstDifference(const World& here, const World& there, const Vector2& offset, double scale = 1)
{
    double worst = 0;
    for (std::size_t i = 0; i < here.bodies().size(); ++i)
    {
        const Pose<2>& a = here.bodies().pose[i];
        const Pose<2>& b = there.bodies().pose[i];
        worst = std::max(worst, ((b.position - offset) / scale - a.position).norm() / 0.025);
        worst = std::max(worst, std::abs(std::remainder(b.rotation.angle() - a.rotation.angle(), 2 * M_PI)));
    }
    return worst;
}

} // namespace

TEST(UnitsAndOffset, aMillionthOfTheSizeIsTheSameSceneToTheBit)
{
    constexpr double scale = 0x1p-20;
    const WorldSettings large = scene(1);
    const WorldSettings small = scene(scale);
    World here(large);
    World there(small);
    const double timeStep = 0.5 * here.stableTimeStep();
    EXPECT_EQ(0.5 * there.stableTimeStep(), timeStep * std::sqrt(scale));
    double worst = 0;
    for (int part = 0; part < 8; ++part)
    {
        run(here, timeStep, 1000);
        run(there, timeStep * std::sqrt(scale), 1000);
        worst = worstDifference(here, there, Vector2::Zero(), scale);
        std::printf("after %d steps: off by %.1e\n", 1000 * (part + 1), worst);
    }
    EXPECT_GT(here.largestRelativeOverlap(), 1e-3);
    EXPECT_EQ(worst, 0);
    EXPECT_EQ(here.doubtfulQueries(), there.doubtfulQueries());
    test::record("dryEngine", "scaleDifference", worst, "-");
}

TEST(UnitsAndOffset, aMillionMetresAwayIsTheSameSceneButForRounding)
{
    // Positions there are multiples of 1.2e-10 m, 5e-9 of a grain: that is what two runs begin to differ by.
    const Vector2 offset(1e6, -1e6);
    const WorldSettings settings = scene(1);
    WorldSettings moved = settings;
    for (GrainState& grain : moved.grains)
    {
        grain.position += offset;
    }
    for (PlaneWall<2>& wall : moved.walls)
    {
        wall.point += offset;
    }
    World here(settings);
    World there(moved);
    const double timeStep = 0.5 * here.stableTimeStep();
    double worst = 0;
    double early = 0;
    for (int part = 0; part < 8; ++part)
    {
        run(here, timeStep, 500);
        run(there, timeStep, 500);
        worst = worstDifference(here, there, offset);
        std::printf("after %d steps: off by %.1e, %zu and %zu near pairs\n", 500 * (part + 1), worst, here.contacts().size(), there.contacts().size());
        early = part == 0 ? worst : early;
    }
    // A free flight's way in a step is rounded alike each time: half a digit of the place, in x and y, times the steps.
    EXPECT_LT(early, 2 * 500 * M_SQRT2 * 0x1p-34 / 0.025);
    EXPECT_EQ(there.doubtfulQueries(), 0u);
    test::record("dryEngine", "offsetDifference", early, "-");
}

TEST(UnitsAndOffset, contactsOfAllPairsAreTheSameAMillionMetresAway)
{
    const std::vector<NamedShape> shapes = shapesTimes(1);
    const Vector2 offset(0x1p20, -0x1p20);
    test::RandomSource random(17);
    int touching = 0;
    double worst = 0;
    for (int i = 0; i < 4000; ++i)
    {
        WorldSettings settings = test::freeBall();
        settings.shapes = shapes;
        settings.grains.resize(2);
        settings.grains[0].shape = i % 4;
        settings.grains[1].shape = i / 4 % 4;
        settings.grains[1].angle = random.uniform(-3, 3);
        // Places that both frames can hold: multiples of the far frame's rounding.
        const Vector2 place = 0.045 * random.direction();
        settings.grains[1].position = Vector2(std::round(place.x() * 0x1p32) * 0x1p-32, std::round(place.y() * 0x1p32) * 0x1p-32);
        World here(settings);
        for (GrainState& grain : settings.grains)
        {
            grain.position += offset;
        }
        World there(settings);
        here.updateForces();
        there.updateForces();
        ASSERT_EQ(here.contacts().size(), there.contacts().size());
        for (std::size_t c = 0; c < here.contacts().size(); ++c)
        {
            touching += here.contacts()[c].depth > 0;
            worst = std::max(worst, std::abs(here.contacts()[c].depth - there.contacts()[c].depth) / 0.05);
        }
    }
    EXPECT_GT(touching, 1000);
    std::printf("%d contacts, depths off by %.1e of a grain\n", touching, worst);
    EXPECT_LT(worst, 4e-8);
    test::record("dryEngine", "offsetDepthDifference", worst, "-");
}
