#include "core/world/pairContact.hpp"
#include "core/world/randomInsertion.hpp"
#include "core/world/world.hpp"

#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <set>

using namespace chesil;

// Whatever moves, turns or strains: every pair of grains that overlaps is among the contacts.

namespace
{

/// Overlapping pairs, one by one, by all images beside the cell.
std::set<std::pair<int, int>> overlapping(const World& world)
{
    std::set<std::pair<int, int>> found;
    const int images = world.cell() ? 2 : 0;
    const auto grains = static_cast<int>(world.bodies().size());
    for (int i = 0; i < grains; ++i)
    {
        for (int j = i + 1; j < grains; ++j)
        {
            for (int m = -images; m <= images; ++m)
            {
                for (int n = -images; n <= images; ++n)
                {
                    const auto a = static_cast<std::size_t>(i);
                    const auto b = static_cast<std::size_t>(j);
                    Pose<2> image = world.bodies().pose[b];
                    image.position += world.cell() ? world.cell()->cell.offset({m, n}) : Vector2(Vector2::Zero());
                    SearchStart start;
                    ContactGeometry<2> contact;
                    if (pairContact(world.shapeOf(a), world.bodies().pose[a], world.shapeOf(b), image, start, contact)
                            == PairStatus::overlapping
                        && contact.depth > 1e-12)
                    {
                        found.insert({i, j});
                    }
                }
            }
        }
    }
    return found;
}

/// Steps a world, and compares now and then.
void expectNoneMissed(WorldSettings settings, double speed, std::uint64_t seed, int steps)
{
    std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
    test::RandomSource random(seed);
    for (GrainState& grain : settings.grains)
    {
        grain.velocity = speed * random.direction();
        grain.angularVelocity = random.uniform(-1, 1) * speed / 0.02;
    }
    World world(std::move(settings));
    world.updateForces();
    const double timeStep = world.stableTimeStep() / 2;
    std::size_t checked = 0;
    for (int step = 0; step < steps; ++step)
    {
        ASSERT_EQ(world.step(timeStep), StepStatus::done);
        if (step % 50 != 0)
        {
            continue;
        }
        for (const auto& [i, j] : overlapping(world))
        {
            ++checked;
            const auto isPair = [i = i, j = j](const Contact<2>& c) { return c.first == i && c.second == j && c.depth > 0; };
            ASSERT_TRUE(std::any_of(world.contacts().begin(), world.contacts().end(), isPair)) << i << ' ' << j << " step " << step;
        }
    }
    EXPECT_GT(checked, 100u);
}

/// Rods with an aspect ratio of 20 and balls of their width, in a box.
WorldSettings rodsAndBalls(std::uint64_t seed)
{
    WorldSettings settings = test::quartzSettings();
    settings.gravity = Vector2::Zero();
    settings.localDamping = 0;
    settings.shapes = {{"rod", Ellipse(0.1, 0.005)}, {"ball", Circle(0.006)},
                       {"slat", ConvexPolygon({{-0.08, -0.004}, {0.08, -0.004}, {0.08, 0.004}, {-0.08, 0.004}})}};
    settings.grains = placeOnLattice(settings.shapes, {0, 1, 2}, 49, {Vector2(0, 0), Vector2(1.5, 1.5)}, seed);
    return settings;
}

} // namespace

TEST(NoPairIsMissed, amongRodsThatTurn)
{
    WorldSettings settings = rodsAndBalls(21);
    settings.walls = {{"floor", Vector2(0, 0), Vector2(0, 1)}, {"left", Vector2(0, 0), Vector2(1, 0)},
                      {"right", Vector2(1.5, 0), Vector2(-1, 0)}, {"lid", Vector2(0, 1.5), Vector2(0, -1)}};
    expectNoneMissed(settings, 1, 21, 20000);
}

TEST(NoPairIsMissed, byARodThatOnlyTurns)
{
    WorldSettings settings = rodsAndBalls(0);
    settings.grains.assign(2, GrainState{});
    settings.grains[0].angularVelocity = 10;
    settings.grains[1].shape = 1;
    settings.grains[1].position = 0.08 * Vector2(std::cos(0.7), std::sin(0.7));
    World world(settings);
    world.updateForces();
    ASSERT_TRUE(world.contacts().empty()) << "the rod's box ends below the ball";
    while (world.time() < 0.1)
    {
        ASSERT_EQ(world.step(world.stableTimeStep() / 2), StepStatus::done);
    }
    EXPECT_GT(world.bodies().velocity[1].norm(), 0.1) << "it was hit";
}

TEST(NoPairIsMissed, amongRodsInAStrainedCell)
{
    WorldSettings settings = rodsAndBalls(22);
    Eigen::Matrix2d gradient;
    gradient << -0.1, 0.5, 0, -0.1;
    settings.cell.emplace(PeriodicCell(Vector2(0, 0), Vector2(1.5, 0), Vector2(0, 1.5)), gradient);
    expectNoneMissed(settings, 1, 22, 20000);
}

TEST(NoPairIsMissed, inACellThatIsShearedFast)
{
    WorldSettings settings = test::quartzSettings();
    settings.gravity = Vector2::Zero();
    settings.shapes = test::shapesOfEachKind(23);
    settings.grains = placeOnLattice(settings.shapes, {0, 1, 2, 3}, 49, {Vector2(0, 0), Vector2(0.5, 0.5)}, 23);
    Eigen::Matrix2d gradient;
    gradient << 0, 5, 0, 0;
    settings.cell.emplace(PeriodicCell(Vector2(0, 0), Vector2(0.5, 0), Vector2(0, 0.5)), gradient);
    expectNoneMissed(settings, 0.3, 23, 10000);
}
