#pragma once

#include "core/broadphase/neighbourSearch.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// Scenes for the neighbour search, and all pairs one by one to compare it with.
namespace chesil::test
{

/// Grains by their boxes and circles.
struct NeighbourScene
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

inline Vector2 randomPosition(double reach, RandomSource& random)
{
    const double x = random.uniform(-reach, reach);
    const double y = random.uniform(-reach, reach);
    return Vector2(x, y);
}

/// `number` disks in a square around the origin, radii from 1/sizeRatio to 1, as dense as `reach` makes it.
inline NeighbourScene randomScene(int number, double reach, double sizeRatio, RandomSource& random)
{
    NeighbourScene scene;
    for (int i = 0; i < number; ++i)
    {
        const Vector2 position = randomPosition(reach, random);
        scene.addDisk(position, sizeRatio > 1 ? random.logUniform(1 / sizeRatio, 1) : 1);
    }
    return scene;
}

/// Rods of half-length 1 at any angle, half as wide as `aspect` says.
inline NeighbourScene randomRods(int number, double reach, double aspect, RandomSource& random)
{
    NeighbourScene scene;
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
inline std::vector<PairKey> bruteForce(const NeighbourScene& scene, double margin)
{
    std::vector<PairKey> pairs;
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

inline std::vector<PairKey> pairsFound(NeighbourSearch& search, const NeighbourScene& scene, double margin)
{
    return search.find(scene.positions, scene.halfExtents, scene.radii, margin);
}

/// Compares the search on a scene with brute force, and counts the pairs.
inline std::size_t checkFound(NeighbourSearch& search, const NeighbourScene& scene, double margin)
{
    const std::vector<PairKey> expected = bruteForce(scene, margin);
    EXPECT_EQ(pairsFound(search, scene, margin), expected);
    return expected.size();
}

/// Shifts of some lattice vectors each way, tried one by one.
inline std::size_t checkPeriodic(NeighbourSearch& search, const NeighbourScene& scene, double margin,
                                 const PeriodicCell& cell)
{
    std::vector<PairKey> expected;
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
                        expected.push_back(
                            {static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), 0, {m, n}});
                    }
                }
            }
        }
    }
    const std::vector<PairKey> found =
        search.find(scene.positions, scene.halfExtents, scene.radii, margin, cell);
    EXPECT_EQ(found, expected);
    const auto sameShift = [](const PairKey& a, const PairKey& b) { return a.shift == b.shift; };
    EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end(), sameShift));
    const auto crosses = [](const PairKey& pair) { return !(pair.shift == NearShift{}); };
    return static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), crosses));
}

} // namespace chesil::test
