#include "core/broadphase/neighbourList.hpp"

#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;
using Pairs = std::vector<NeighbourSearch::Pair>;

namespace
{

struct Scene
{
    std::vector<Vector2> positions;
    std::vector<double> radii;

    void add(const Vector2& position, double radius)
    {
        positions.push_back(position);
        radii.push_back(radius);
    }
};

/// `number` grains in a square around the origin, radii from 1/sizeRatio to 1, as dense as `reach` makes it.
Scene randomScene(int number, double reach, double sizeRatio, test::RandomSource& random)
{
    Scene scene;
    for (int i = 0; i < number; ++i)
    {
        const double x = random.uniform(-reach, reach);
        const double y = random.uniform(-reach, reach);
        scene.add({x, y}, sizeRatio > 1 ? random.logUniform(1 / sizeRatio, 1) : 1);
    }
    return scene;
}

/// All pairs, one by one, in the order that the search promises.
Pairs bruteForce(const Scene& scene, double margin)
{
    Pairs pairs;
    for (std::size_t i = 0; i < scene.positions.size(); ++i)
    {
        for (std::size_t j = i + 1; j < scene.positions.size(); ++j)
        {
            const double reach = scene.radii[i] + scene.radii[j] + margin;
            if ((scene.positions[i] - scene.positions[j]).squaredNorm() <= reach * reach)
            {
                pairs.emplace_back(i, j);
            }
        }
    }
    return pairs;
}

} // namespace

TEST(NeighbourSearch, randomScenes)
{
    test::RandomSource random(101);
    NeighbourSearch search;
    std::size_t found = 0;
    for (int i = 0; i < 60; ++i)
    {
        const Scene scene =
            randomScene(random.integer(2, 300), random.logUniform(3, 100), i % 2 == 0 ? 1 : 50, random);
        const double margin = i % 3 == 0 ? 0 : random.uniform(0, 1);
        const Pairs expected = bruteForce(scene, margin);
        ASSERT_EQ(search.find(scene.positions, scene.radii, margin), expected) << "scene " << i;
        found += expected.size();
    }
    EXPECT_GT(found, 10000u);
}

TEST(NeighbourSearch, grainsOnCellBorders)
{
    // Radius 1 and no margin make cells of 2: all on corners of cells, all touching their neighbours.
    Scene scene;
    for (int x = -3; x <= 3; ++x)
    {
        for (int y = -3; y <= 3; ++y)
        {
            scene.add({2.0 * x, 2.0 * y}, 1);
        }
    }
    NeighbourSearch search;
    const Pairs pairs = search.find(scene.positions, scene.radii, 0);
    EXPECT_EQ(pairs, bruteForce(scene, 0));
    EXPECT_EQ(pairs.size(), 2u * 6 * 7);
}

TEST(NeighbourSearch, aGrainFlungFarAway)
{
    test::RandomSource random(102);
    Scene scene = randomScene(200, 10, 50, random);
    NeighbourSearch search;
    for (const double far : {1e6, -1e15, 1e200, -1e300})
    {
        scene.positions[17] = Vector2(far, -far);
        scene.positions[18] = Vector2(far, 3);
        EXPECT_EQ(search.find(scene.positions, scene.radii, 0.1), bruteForce(scene, 0.1)) << far;
    }
}

TEST(NeighbourSearch, aPositionThatIsNotANumberHasNoNeighbours)
{
    test::RandomSource random(103);
    Scene scene = randomScene(50, 5, 1, random);
    scene.positions[7] = Vector2(std::numeric_limits<double>::quiet_NaN(), 0);
    scene.positions[9] = Vector2(0, std::numeric_limits<double>::infinity());
    NeighbourSearch search;
    EXPECT_EQ(search.find(scene.positions, scene.radii, 0.1), bruteForce(scene, 0.1));
}

TEST(NeighbourSearch, noneAndOne)
{
    NeighbourSearch search;
    EXPECT_TRUE(search.find({}, {}, 0).empty());
    EXPECT_TRUE(search.find({Vector2(1, 2)}, {0.5}, 0).empty());
}

TEST(NeighbourSearch, forgetsTheSceneBefore)
{
    test::RandomSource random(104);
    NeighbourSearch search;
    search.find(randomScene(100, 5, 1, random).positions, std::vector<double>(100, 1.0), 0);
    const Scene next = randomScene(20, 5, 50, random);
    EXPECT_EQ(search.find(next.positions, next.radii, 0), bruteForce(next, 0));
}
