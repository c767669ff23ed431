#include "core/base/setupError.hpp"
#include "unit/core/broadphase/neighbourScenes.hpp"

#include <array>

using namespace chesil;
using test::checkPeriodic;
using test::NeighbourScene;
using test::randomRods;
using test::randomScene;

namespace
{

/// Of like size, of sizes between 1:100 and 1:1000, rods: in the cell, and some a little off it.
void checkPeriodicScenes(const PeriodicCell& cell, std::uint64_t seed)
{
    test::RandomSource random(seed);
    NeighbourSearch search;
    std::size_t across = 0;
    for (int k = 0; k < 24; ++k)
    {
        NeighbourScene scene = k % 4 == 3
                                   ? randomRods(250, 12, 50, random)
                                   : randomScene(250, 12, std::array<double, 3>{1, 100, 1000}[k % 4], random);
        for (std::size_t i = 0; i < scene.positions.size(); ++i)
        {
            if (i % 5 != 0)
            {
                cell.wrap(scene.positions[i]);
            }
        }
        across += checkPeriodic(search, scene, k % 3 * 0.2, cell);
    }
    EXPECT_GT(across, 500u);
}

} // namespace

TEST(PeriodicNeighbourSearch, straightCell)
{
    checkPeriodicScenes({Vector2(-5, -5), Vector2(11, 0), Vector2(0, 9)}, 110);
}

TEST(PeriodicNeighbourSearch, tiltedCell)
{
    checkPeriodicScenes({Vector2(-5, -5), Vector2(11, 0), Vector2(5.5, 9)}, 111);
    checkPeriodicScenes({Vector2(-5, -5), Vector2(11, 1), Vector2(-8, 9)}, 112);
    checkPeriodicScenes({Vector2(5, -5), Vector2(0, 9), Vector2(11, 2)}, 113);
}

TEST(PeriodicNeighbourSearch, cellOfOneDirection)
{
    checkPeriodicScenes({Vector2(-5, -5), Vector2(9, 0), Vector2(0, 0)}, 114);
    checkPeriodicScenes({Vector2(-5, -5), Vector2(0, 0), Vector2(3, 9)}, 115);
}

TEST(PeriodicNeighbourSearch, cellOfTheLeastWidth)
{
    // 4 times the largest radius and 2 times the margin is 4.2.
    test::RandomSource random(116);
    const PeriodicCell cell(Vector2(0, 0), Vector2(4.2001, 0), Vector2(0, 4.2002));
    NeighbourSearch search;
    for (int k = 0; k < 30; ++k)
    {
        NeighbourScene scene = randomScene(40, 4, k % 2 == 0 ? 1 : 100, random);
        for (Vector2& position : scene.positions)
        {
            cell.wrap(position);
        }
        EXPECT_GT(checkPeriodic(search, scene, 0.1, cell), 0u);
    }
}

TEST(PeriodicNeighbourSearch, refusesATooNarrowCell)
{
    NeighbourSearch search;
    NeighbourScene scene;
    scene.addDisk(Vector2(1, 1), 1);
    const auto findIn = [&](const Vector2& first, const Vector2& second)
    {
        search.find(scene.positions, scene.halfExtents, scene.radii, 0.1,
                    PeriodicCell(Vector2(0, 0), first, second));
    };
    EXPECT_NO_THROW(findIn(Vector2(4.3, 0), Vector2(0, 4.3)));
    EXPECT_THROW(findIn(Vector2(4.1, 0), Vector2(0, 9)), ValueError);
    EXPECT_THROW(findIn(Vector2(9, 0), Vector2(0, 4.1)), ValueError);
    // Sides long enough, but too near each other.
    EXPECT_THROW(findIn(Vector2(5, 0), Vector2(5, 5)), ValueError);
    EXPECT_THROW(findIn(Vector2(0, 0), Vector2(4.1, 0)), ValueError);
}

TEST(PeriodicNeighbourSearch, refusesPositionsFarFromTheCell)
{
    NeighbourSearch search;
    NeighbourScene scene;
    scene.addDisk(Vector2(1, 1), 1);
    scene.addDisk(Vector2(1e12, 1), 1);
    const PeriodicCell cell(Vector2(0, 0), Vector2(10, 0), Vector2(0, 10));
    EXPECT_THROW(search.find(scene.positions, scene.halfExtents, scene.radii, 0, cell), ValueError);
}
