#include "unit/core/broadphase/neighbourScenes.hpp"

#include <array>
#include <limits>

using namespace chesil;
using test::checkFound;
using test::checkPeriodic;
using test::NeighbourScene;
using test::pairsFound;
using test::randomPosition;
using test::randomRods;
using test::randomScene;

TEST(NeighbourSearch, randomScenes)
{
    test::RandomSource random(101);
    NeighbourSearch search;
    std::size_t pairs = 0;
    for (int i = 0; i < 120; ++i)
    {
        const double sizeRatio = std::array<double, 4>{1, 3, 100, 1000}[static_cast<std::size_t>(i) % 4];
        const NeighbourScene scene =
            randomScene(random.integer(2, 400), random.logUniform(3, 100), sizeRatio, random);
        pairs += checkFound(search, scene, i % 3 == 0 ? 0 : random.uniform(0, 1));
    }
    EXPECT_GT(pairs, 30000u);
}

TEST(NeighbourSearch, fewLargeAmongManySmall)
{
    test::RandomSource random(105);
    NeighbourSearch search;
    for (const double sizeRatio : {10.0, 100.0, 1000.0})
    {
        NeighbourScene scene;
        for (int i = 0; i < 1500; ++i)
        {
            scene.addDisk(randomPosition(3, random), i % 150 == 7 ? 1 : 1 / sizeRatio);
        }
        EXPECT_GT(checkFound(search, scene, 0.3 / sizeRatio), 1000u);
    }
}

TEST(NeighbourSearch, slenderGrains)
{
    test::RandomSource random(106);
    NeighbourSearch search;
    for (int i = 0; i < 20; ++i)
    {
        const NeighbourScene scene = randomRods(300, random.logUniform(2, 20), 50, random);
        EXPECT_GT(checkFound(search, scene, 0.02 * (i % 3)), 10u);
    }
}

TEST(NeighbourSearch, boxesOfAnySizeAndAspect)
{
    // Lying ones among upright ones of other sizes: a finer level wider than a coarser one is high.
    test::RandomSource random(117);
    NeighbourSearch search;
    std::size_t pairs = 0;
    for (int i = 0; i < 30; ++i)
    {
        NeighbourScene scene;
        for (int k = 0; k < 300; ++k)
        {
            const Vector2 position = randomPosition(6, random);
            const double large = random.logUniform(0.01, 2);
            const double aspect = random.logUniform(large > 0.5 ? 20 : 1, 200);
            const Vector2 half =
                large > 0.5 ? Vector2(large / aspect, large) : Vector2(large, large / aspect);
            scene.add(position, half, half.norm());
        }
        pairs += checkFound(search, scene, 0.01 * (i % 3));
    }
    EXPECT_GT(pairs, 1000u);
}

TEST(NeighbourSearch, boxesKeepApartWhatCirclesDoNot)
{
    NeighbourScene scene;
    for (int row = 0; row < 40; ++row)
    {
        scene.add(Vector2(0, 0.05 * row), Vector2(1, 0.02), std::hypot(1, 0.02));
    }
    NeighbourSearch search;
    EXPECT_TRUE(pairsFound(search, scene, 0.009).empty());
    EXPECT_EQ(pairsFound(search, scene, 0.011).size(), 39u);
}

TEST(NeighbourSearch, clusters)
{
    test::RandomSource random(107);
    NeighbourSearch search;
    NeighbourScene scene;
    for (int cluster = 0; cluster < 12; ++cluster)
    {
        const Vector2 centre = randomPosition(1e7, random);
        for (int i = 0; i < 80; ++i)
        {
            scene.addDisk(centre + randomPosition(5, random), random.logUniform(0.05, 1));
        }
    }
    EXPECT_GT(checkFound(search, scene, 0.1), 500u);
}

TEST(NeighbourSearch, chainsAlongTheAxesAndAcross)
{
    NeighbourSearch search;
    for (const Vector2& step : {Vector2(2, 0), Vector2(0, 2), Vector2(-2, 2), Vector2(2, 2)})
    {
        NeighbourScene scene;
        for (int i = 0; i < 1000; ++i)
        {
            scene.addDisk(i * step, step.norm() / 2);
        }
        EXPECT_EQ(checkFound(search, scene, 0.1), 999u);
    }
}

TEST(NeighbourSearch, grainsOnCellBorders)
{
    // Radius 1 and no margin make cells of 2: all about corners of cells, all touching their neighbours.
    NeighbourScene scene;
    for (int x = -3; x <= 3; ++x)
    {
        for (int y = -3; y <= 3; ++y)
        {
            scene.addDisk({2.0 * x, 2.0 * y}, 1);
        }
    }
    NeighbourSearch search;
    EXPECT_EQ(checkFound(search, scene, 0), 2u * 6 * 7);
}

TEST(NeighbourSearch, aGrainFlungFarAway)
{
    test::RandomSource random(102);
    NeighbourScene scene = randomScene(200, 10, 50, random);
    NeighbourSearch search;
    for (const double far : {1e6, 1e12, -1e15, 1e200, -1e300})
    {
        scene.positions[17] = Vector2(far, -far);
        scene.positions[18] = Vector2(far, 3);
        scene.positions[19] = Vector2(far, 4);
        EXPECT_GT(checkFound(search, scene, 0.1), 50u) << far;
    }
}

TEST(NeighbourSearch, touchingGrainsFarAway)
{
    // Positions are as coarse as the steps between them there.
    for (const double far : {1e9, 1e12, -1e14, 1e15, 1e17})
    {
        test::RandomSource random(108);
        NeighbourScene scene;
        for (int i = 0; i < 300; ++i)
        {
            scene.addDisk(Vector2(far, -far) + randomPosition(15, random), 1);
        }
        NeighbourSearch search;
        EXPECT_GT(checkFound(search, scene, 0), 300u) << far;
    }
}

TEST(NeighbourSearch, aNumberThatIsNotFiniteMeansNoNeighbours)
{
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    test::RandomSource random(103);
    NeighbourScene scene = randomScene(60, 5, 1, random);
    scene.positions[7] = Vector2(notANumber, 0);
    scene.positions[9] = Vector2(0, infinity);
    scene.positions[10] = Vector2(-infinity, infinity);
    scene.halfExtents[12] = Vector2(1, notANumber);
    scene.radii[14] = notANumber;
    NeighbourSearch search;
    EXPECT_GT(checkFound(search, scene, 0.1), 100u);
    const PeriodicCell cell(Vector2(-5, -5), Vector2(10, 0), Vector2(0, 10));
    EXPECT_GT(checkPeriodic(search, scene, 0.1, cell), 10u);
    scene.positions.assign(60, Vector2(notANumber, notANumber));
    EXPECT_EQ(checkFound(search, scene, 0.1), 0u);
}

TEST(NeighbourSearch, noneAndOne)
{
    NeighbourSearch search;
    const PeriodicCell cell(Vector2(0, 0), Vector2(10, 0), Vector2(0, 10));
    NeighbourScene scene;
    EXPECT_EQ(checkFound(search, scene, 0), 0u);
    EXPECT_EQ(checkPeriodic(search, scene, 0, cell), 0u);
    scene.addDisk(Vector2(0, 10), 0.5);
    EXPECT_EQ(checkFound(search, scene, 0), 0u);
    EXPECT_EQ(checkPeriodic(search, scene, 0, cell), 0u);
}

TEST(NeighbourSearch, allInOnePlace)
{
    NeighbourSearch search;
    for (const double radius : {1.0, 0.0})
    {
        NeighbourScene scene;
        for (int i = 0; i < 200; ++i)
        {
            scene.addDisk(Vector2(3, -4), radius);
        }
        EXPECT_EQ(checkFound(search, scene, 0), 200u * 199 / 2);
    }
}

TEST(NeighbourSearch, forgetsTheSceneBefore)
{
    test::RandomSource random(104);
    NeighbourSearch search;
    const PeriodicCell cell(Vector2(-5, -5), Vector2(10, 0), Vector2(0, 10));
    checkFound(search, randomScene(300, 5, 1, random), 0);
    checkPeriodic(search, randomScene(100, 5, 1, random), 0, cell);
    EXPECT_GT(checkFound(search, randomScene(40, 3, 10, random), 0), 0u);
}

TEST(NeighbourSearch, keepsItsMemory)
{
    test::RandomSource random(109);
    NeighbourSearch search;
    const NeighbourScene scene = randomScene(300, 10, 50, random);
    checkFound(search, scene, 0.1);
    const std::size_t bytes = search.bytes();
    checkFound(search, scene, 0.1);
    EXPECT_EQ(search.bytes(), bytes);
}
