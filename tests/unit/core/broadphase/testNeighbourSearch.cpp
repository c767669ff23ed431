#include "core/broadphase/neighbourSearch.hpp"

#include "core/base/setupError.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;
using Pairs = std::vector<PairKey>;

namespace
{

struct Scene
{
    std::vector<Vector2> positions;
    std::vector<Vector2> halfExtents;
    std::vector<double> radii;

    void add(const Vector2& position, const Vector2& halfExtent, double radius)
    {
        positions.push_back(position);
        halfExtents.push_back(halfExtent);
        radii.push_back(radius);
    }

    void addDisk(const Vector2& position, double radius) { add(position, Vector2(radius, radius), radius); }

    bool areNear(std::size_t i, std::size_t j, const Vector2& offset, double margin) const
    {
        const Vector2 between = positions[j] + offset - positions[i];
        const auto reach = [margin](double a, double b) { return (a + margin / 2) + (b + margin / 2); };
        const double circles = reach(radii[i], radii[j]);
        return std::abs(between.x()) <= reach(halfExtents[i].x(), halfExtents[j].x()) &&
               std::abs(between.y()) <= reach(halfExtents[i].y(), halfExtents[j].y()) &&
               between.squaredNorm() <= circles * circles;
    }
};

Vector2 randomPosition(double reach, test::RandomSource& random)
{
    const double x = random.uniform(-reach, reach);
    const double y = random.uniform(-reach, reach);
    return Vector2(x, y);
}

/// `number` disks in a square around the origin, radii from 1/sizeRatio to 1, as dense as `reach` makes it.
Scene randomScene(int number, double reach, double sizeRatio, test::RandomSource& random)
{
    Scene scene;
    for (int i = 0; i < number; ++i)
    {
        const Vector2 position = randomPosition(reach, random);
        scene.addDisk(position, sizeRatio > 1 ? random.logUniform(1 / sizeRatio, 1) : 1);
    }
    return scene;
}

/// Rods of half-length 1 at any angle, half as wide as `aspect` says.
Scene randomRods(int number, double reach, double aspect, test::RandomSource& random)
{
    Scene scene;
    for (int i = 0; i < number; ++i)
    {
        const Vector2 position = randomPosition(reach, random);
        const Vector2 along = i % 3 == 0 ? Vector2(Vector2::UnitX()) : random.direction();
        const Vector2 half = along.cwiseAbs() + perpendicular(along).cwiseAbs() / aspect;
        scene.add(position, half, std::hypot(1, 1 / aspect));
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
            if (scene.areNear(i, j, Vector2::Zero(), margin))
            {
                pairs.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)});
            }
        }
    }
    return pairs;
}

Pairs found(NeighbourSearch& search, const Scene& scene, double margin)
{
    return search.find(scene.positions, scene.halfExtents, scene.radii, margin);
}

/// Compares the search on a scene with brute force, and counts the pairs.
std::size_t check(NeighbourSearch& search, const Scene& scene, double margin)
{
    const Pairs expected = bruteForce(scene, margin);
    EXPECT_EQ(found(search, scene, margin), expected);
    return expected.size();
}

/// Shifts of some lattice vectors each way, tried one by one.
std::size_t checkPeriodic(NeighbourSearch& search, const Scene& scene, double margin,
                          const PeriodicCell& cell)
{
    Pairs expected;
    const int mostSecond = cell.second().isZero(0) ? 0 : 3;
    const int mostFirst = cell.first().isZero(0) ? 0 : 3;
    for (std::size_t i = 0; i < scene.positions.size(); ++i)
    {
        for (std::size_t j = i + 1; j < scene.positions.size(); ++j)
        {
            for (std::int8_t m = static_cast<std::int8_t>(-mostFirst); m <= mostFirst; ++m)
            {
                for (std::int8_t n = static_cast<std::int8_t>(-mostSecond); n <= mostSecond; ++n)
                {
                    if (scene.areNear(i, j, cell.offset({m, n}), margin))
                    {
                        expected.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), 0, {m, n}});
                    }
                }
            }
        }
    }
    const Pairs found = search.find(scene.positions, scene.halfExtents, scene.radii, margin, cell);
    EXPECT_EQ(found, expected);
    const auto sameShift = [](const PairKey& a, const PairKey& b) { return a.shift == b.shift; };
    EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end(), sameShift));
    const auto crosses = [](const PairKey& pair) { return !(pair.shift == NearShift{}); };
    return static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), crosses));
}

/// Of like size, of sizes between 1:100 and 1:1000, rods: in the cell, and some a little off it.
void checkPeriodicScenes(const PeriodicCell& cell, std::uint64_t seed)
{
    test::RandomSource random(seed);
    NeighbourSearch search;
    std::size_t across = 0;
    for (int k = 0; k < 24; ++k)
    {
        Scene scene = k % 4 == 3 ? randomRods(250, 12, 50, random)
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

TEST(NeighbourSearch, randomScenes)
{
    test::RandomSource random(101);
    NeighbourSearch search;
    std::size_t pairs = 0;
    for (int i = 0; i < 120; ++i)
    {
        const double sizeRatio = std::array<double, 4>{1, 3, 100, 1000}[static_cast<std::size_t>(i) % 4];
        const Scene scene = randomScene(random.integer(2, 400), random.logUniform(3, 100), sizeRatio, random);
        pairs += check(search, scene, i % 3 == 0 ? 0 : random.uniform(0, 1));
    }
    EXPECT_GT(pairs, 30000u);
}

TEST(NeighbourSearch, fewLargeAmongManySmall)
{
    test::RandomSource random(105);
    NeighbourSearch search;
    for (const double sizeRatio : {10.0, 100.0, 1000.0})
    {
        Scene scene;
        for (int i = 0; i < 1500; ++i)
        {
            scene.addDisk(randomPosition(3, random), i % 150 == 7 ? 1 : 1 / sizeRatio);
        }
        EXPECT_GT(check(search, scene, 0.3 / sizeRatio), 1000u);
    }
}

TEST(NeighbourSearch, slenderGrains)
{
    test::RandomSource random(106);
    NeighbourSearch search;
    for (int i = 0; i < 20; ++i)
    {
        const Scene scene = randomRods(300, random.logUniform(2, 20), 50, random);
        EXPECT_GT(check(search, scene, 0.02 * (i % 3)), 10u);
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
        Scene scene;
        for (int k = 0; k < 300; ++k)
        {
            const Vector2 position = randomPosition(6, random);
            const double large = random.logUniform(0.01, 2);
            const double aspect = random.logUniform(large > 0.5 ? 20 : 1, 200);
            const Vector2 half =
                large > 0.5 ? Vector2(large / aspect, large) : Vector2(large, large / aspect);
            scene.add(position, half, half.norm());
        }
        pairs += check(search, scene, 0.01 * (i % 3));
    }
    EXPECT_GT(pairs, 1000u);
}

TEST(NeighbourSearch, boxesKeepApartWhatCirclesDoNot)
{
    Scene scene;
    for (int row = 0; row < 40; ++row)
    {
        scene.add(Vector2(0, 0.05 * row), Vector2(1, 0.02), std::hypot(1, 0.02));
    }
    NeighbourSearch search;
    EXPECT_TRUE(found(search, scene, 0.009).empty());
    EXPECT_EQ(found(search, scene, 0.011).size(), 39u);
}

TEST(NeighbourSearch, clusters)
{
    test::RandomSource random(107);
    NeighbourSearch search;
    Scene scene;
    for (int cluster = 0; cluster < 12; ++cluster)
    {
        const Vector2 centre = randomPosition(1e7, random);
        for (int i = 0; i < 80; ++i)
        {
            scene.addDisk(centre + randomPosition(5, random), random.logUniform(0.05, 1));
        }
    }
    EXPECT_GT(check(search, scene, 0.1), 500u);
}

TEST(NeighbourSearch, chainsAlongTheAxesAndAcross)
{
    NeighbourSearch search;
    for (const Vector2& step : {Vector2(2, 0), Vector2(0, 2), Vector2(-2, 2), Vector2(2, 2)})
    {
        Scene scene;
        for (int i = 0; i < 1000; ++i)
        {
            scene.addDisk(i * step, step.norm() / 2);
        }
        EXPECT_EQ(check(search, scene, 0.1), 999u);
    }
}

TEST(NeighbourSearch, grainsOnCellBorders)
{
    // Radius 1 and no margin make cells of 2: all about corners of cells, all touching their neighbours.
    Scene scene;
    for (int x = -3; x <= 3; ++x)
    {
        for (int y = -3; y <= 3; ++y)
        {
            scene.addDisk({2.0 * x, 2.0 * y}, 1);
        }
    }
    NeighbourSearch search;
    EXPECT_EQ(check(search, scene, 0), 2u * 6 * 7);
}

TEST(NeighbourSearch, aGrainFlungFarAway)
{
    test::RandomSource random(102);
    Scene scene = randomScene(200, 10, 50, random);
    NeighbourSearch search;
    for (const double far : {1e6, 1e12, -1e15, 1e200, -1e300})
    {
        scene.positions[17] = Vector2(far, -far);
        scene.positions[18] = Vector2(far, 3);
        scene.positions[19] = Vector2(far, 4);
        EXPECT_GT(check(search, scene, 0.1), 50u) << far;
    }
}

TEST(NeighbourSearch, touchingGrainsFarAway)
{
    // Positions are as coarse as the steps between them there.
    for (const double far : {1e9, 1e12, -1e14, 1e15, 1e17})
    {
        test::RandomSource random(108);
        Scene scene;
        for (int i = 0; i < 300; ++i)
        {
            scene.addDisk(Vector2(far, -far) + randomPosition(15, random), 1);
        }
        NeighbourSearch search;
        EXPECT_GT(check(search, scene, 0), 300u) << far;
    }
}

TEST(NeighbourSearch, aNumberThatIsNotFiniteMeansNoNeighbours)
{
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    test::RandomSource random(103);
    Scene scene = randomScene(60, 5, 1, random);
    scene.positions[7] = Vector2(notANumber, 0);
    scene.positions[9] = Vector2(0, infinity);
    scene.positions[10] = Vector2(-infinity, infinity);
    scene.halfExtents[12] = Vector2(1, notANumber);
    scene.radii[14] = notANumber;
    NeighbourSearch search;
    EXPECT_GT(check(search, scene, 0.1), 100u);
    const PeriodicCell cell(Vector2(-5, -5), Vector2(10, 0), Vector2(0, 10));
    EXPECT_GT(checkPeriodic(search, scene, 0.1, cell), 10u);
    scene.positions.assign(60, Vector2(notANumber, notANumber));
    EXPECT_EQ(check(search, scene, 0.1), 0u);
}

TEST(NeighbourSearch, noneAndOne)
{
    NeighbourSearch search;
    const PeriodicCell cell(Vector2(0, 0), Vector2(10, 0), Vector2(0, 10));
    Scene scene;
    EXPECT_EQ(check(search, scene, 0), 0u);
    EXPECT_EQ(checkPeriodic(search, scene, 0, cell), 0u);
    scene.addDisk(Vector2(0, 10), 0.5);
    EXPECT_EQ(check(search, scene, 0), 0u);
    EXPECT_EQ(checkPeriodic(search, scene, 0, cell), 0u);
}

TEST(NeighbourSearch, allInOnePlace)
{
    NeighbourSearch search;
    for (const double radius : {1.0, 0.0})
    {
        Scene scene;
        for (int i = 0; i < 200; ++i)
        {
            scene.addDisk(Vector2(3, -4), radius);
        }
        EXPECT_EQ(check(search, scene, 0), 200u * 199 / 2);
    }
}

TEST(NeighbourSearch, forgetsTheSceneBefore)
{
    test::RandomSource random(104);
    NeighbourSearch search;
    const PeriodicCell cell(Vector2(-5, -5), Vector2(10, 0), Vector2(0, 10));
    check(search, randomScene(300, 5, 1, random), 0);
    checkPeriodic(search, randomScene(100, 5, 1, random), 0, cell);
    EXPECT_GT(check(search, randomScene(40, 3, 10, random), 0), 0u);
}

TEST(NeighbourSearch, keepsItsMemory)
{
    test::RandomSource random(109);
    NeighbourSearch search;
    const Scene scene = randomScene(300, 10, 50, random);
    check(search, scene, 0.1);
    const std::size_t bytes = search.bytes();
    check(search, scene, 0.1);
    EXPECT_EQ(search.bytes(), bytes);
}

TEST(NeighbourSearch, straightCell)
{
    checkPeriodicScenes({Vector2(-5, -5), Vector2(11, 0), Vector2(0, 9)}, 110);
}

TEST(NeighbourSearch, tiltedCell)
{
    checkPeriodicScenes({Vector2(-5, -5), Vector2(11, 0), Vector2(5.5, 9)}, 111);
    checkPeriodicScenes({Vector2(-5, -5), Vector2(11, 1), Vector2(-8, 9)}, 112);
    checkPeriodicScenes({Vector2(5, -5), Vector2(0, 9), Vector2(11, 2)}, 113);
}

TEST(NeighbourSearch, cellOfOneDirection)
{
    checkPeriodicScenes({Vector2(-5, -5), Vector2(9, 0), Vector2(0, 0)}, 114);
    checkPeriodicScenes({Vector2(-5, -5), Vector2(0, 0), Vector2(3, 9)}, 115);
}

TEST(NeighbourSearch, cellOfTheLeastWidth)
{
    // 4 times the largest radius and 2 times the margin is 4.2.
    test::RandomSource random(116);
    const PeriodicCell cell(Vector2(0, 0), Vector2(4.2001, 0), Vector2(0, 4.2002));
    NeighbourSearch search;
    for (int k = 0; k < 30; ++k)
    {
        Scene scene = randomScene(40, 4, k % 2 == 0 ? 1 : 100, random);
        for (Vector2& position : scene.positions)
        {
            cell.wrap(position);
        }
        EXPECT_GT(checkPeriodic(search, scene, 0.1, cell), 0u);
    }
}

TEST(NeighbourSearch, refusesATooNarrowCell)
{
    NeighbourSearch search;
    Scene scene;
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

TEST(NeighbourSearch, refusesPositionsFarFromTheCell)
{
    NeighbourSearch search;
    Scene scene;
    scene.addDisk(Vector2(1, 1), 1);
    scene.addDisk(Vector2(1e12, 1), 1);
    const PeriodicCell cell(Vector2(0, 0), Vector2(10, 0), Vector2(0, 10));
    EXPECT_THROW(search.find(scene.positions, scene.halfExtents, scene.radii, 0, cell), ValueError);
}
