#pragma once

#include "core/base/vector.hpp"
#include "unit/randomGrain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace chesil::benchmark
{

constexpr std::uint64_t sceneSeed = 20240801;

/// Lengths are in radii of the smallest grain.
constexpr double sceneMargin = 0.3;

/// Grains as the search wants them.
struct Scene
{
    std::vector<Vector2> positions;
    std::vector<Vector2> halfExtents;
    std::vector<double> radii;
    /// Side of the square that a periodic scene repeats; 0 if it does not.
    double period = 0;

    std::size_t size() const { return positions.size(); }

    void add(const Vector2& position, const Vector2& half, double radius)
    {
        positions.push_back(position);
        halfExtents.push_back(half);
        radii.push_back(radius);
    }

    void addDisk(const Vector2& position, double radius) { add(position, Vector2(radius, radius), radius); }
};

/// Between neighbours of a hexagonal lattice of disks of radius 1 with solid fraction 0.8.
inline double latticePitch() { return 2 * std::sqrt(M_PI / std::sqrt(12.0) / 0.8); }

/// Disks of radius 1 on that lattice, out of place by up to 0.05, row by row, but where large ones of radius
/// `ratio` are: these stand in a square lattice and cover half of the space. None for ratio 1.
inline Scene twoSizes(std::size_t number, double ratio)
{
    test::RandomSource random(sceneSeed);
    Scene scene;
    const double largePitch = 2.5 * ratio;
    const double pitch = latticePitch();
    const double rowPitch = pitch * std::sqrt(0.75);
    const double share = ratio > 1 ? 1 - M_PI / (2.5 * 2.5) : 1;
    const double side = std::max(std::sqrt(static_cast<double>(number) * pitch * rowPitch / share),
                                 ratio > 1 ? largePitch : 0);
    const auto across = static_cast<int>(ratio > 1 ? std::ceil(side / largePitch) : 0);
    for (int k = 0; k < across * across; ++k)
    {
        scene.addDisk(Vector2(k % across + 0.5, k / across + 0.5) * largePitch, ratio);
    }
    const auto isCovered = [&](const Vector2& at)
    {
        const Vector2 centre((std::floor(at.x() / largePitch) + 0.5) * largePitch,
                             (std::floor(at.y() / largePitch) + 0.5) * largePitch);
        return ratio > 1 && (at - centre).norm() < ratio + 1;
    };
    for (int row = 0; scene.size() < number; ++row)
    {
        for (int column = 0; column * pitch < side && scene.size() < number; ++column)
        {
            const double x = (column + row % 2 * 0.5) * pitch + random.uniform(-0.05, 0.05);
            const double y = row * rowPitch + random.uniform(-0.05, 0.05);
            if (!isCovered({x, y}))
            {
                scene.addDisk({x, y}, 1);
            }
        }
    }
    return scene;
}

/// The grains of a scene in another order.
inline Scene shuffled(const Scene& scene)
{
    test::RandomSource random(sceneSeed);
    std::vector<std::size_t> order(scene.size());
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size(); i-- > 1;)
    {
        std::swap(order[i], order[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
    }
    Scene result;
    for (const std::size_t i : order)
    {
        result.add(scene.positions[i], scene.halfExtents[i], scene.radii[i]);
    }
    return result;
}

/// Disks anywhere in a square, numbered at random, radii from 1 to `ratio` evenly in the logarithm; as dense
/// as gives three near pairs a grain.
inline Scene allSizes(std::size_t number, double ratio)
{
    test::RandomSource random(sceneSeed);
    double sum = 0;
    double squares = 0;
    std::vector<double> radii;
    for (std::size_t i = 0; i < number; ++i)
    {
        radii.push_back(random.logUniform(1, std::max(ratio, 1 + 1e-9)));
        sum += radii.back() + sceneMargin / 2;
        squares += std::pow(radii.back() + sceneMargin / 2, 2);
    }
    // The mean of pi (a + b)^2 over all pairs is what a partner must be in.
    const double mean = sum / static_cast<double>(number);
    const double area = M_PI * (2 * squares / static_cast<double>(number) + 2 * mean * mean);
    const double side = std::sqrt(static_cast<double>(number) * area / 6);
    Scene scene;
    for (const double radius : radii)
    {
        const double x = random.uniform(0, side);
        scene.addDisk({x, random.uniform(0, side)}, radius);
    }
    return scene;
}

/// Rods of 50:1 laid like bricks, half a width 1, a tenth apart.
inline Scene layers(std::size_t number)
{
    test::RandomSource random(sceneSeed);
    const auto across = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(number) / 50)));
    Scene scene;
    for (std::size_t k = 0; k < number; ++k)
    {
        const double row = static_cast<double>(k / across);
        const double x = 100.1 * static_cast<double>(k % across) + random.uniform(0, 50);
        scene.add({x, 2.1 * row}, {50, 1}, std::hypot(50, 1));
    }
    return scene;
}

} // namespace chesil::benchmark
