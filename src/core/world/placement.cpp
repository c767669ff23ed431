#include "core/world/placement.hpp"

#include "core/base/setupError.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace chesil
{

namespace
{

/// Uniform on [0, 1), the same bits with every standard library (std::uniform_real_distribution is not).
double uniform(std::mt19937_64& engine)
{
    return static_cast<double>(engine() >> 11) * 0x1p-53;
}

} // namespace

std::vector<GrainState> placeOnLattice(
    const std::vector<NamedShape>& shapes, const std::vector<int>& choice, int number, const PlacementBox& box, std::uint64_t seed)
{
    double widest = 0;
    std::string name;
    for (const int index : choice)
    {
        const NamedShape& shape = shapes[static_cast<std::size_t>(index)];
        const double width = 2 * boundingRadius(shape.shape);
        if (width > widest)
        {
            widest = width;
            name = shape.name;
        }
    }
    const Vector2 extent = box.upper - box.lower;
    if (widest > extent.x() || widest > extent.y())
    {
        throw ValueError(
            "a box of " + numberText(extent.x()) + " x " + numberText(extent.y()) + " m for grain " + name + ", "
                + numberText(widest) + " m wide",
            "a box wider than its grains");
    }
    const int columns = static_cast<int>(extent.x() / widest);
    const int rows = static_cast<int>(extent.y() / widest);
    if (static_cast<double>(columns) * rows < number)
    {
        throw ValueError(
            std::to_string(number) + " grains in a box with " + std::to_string(columns) + " x " + std::to_string(rows)
                + " places of " + numberText(widest) + " m",
            "fewer grains, or a higher box");
    }

    std::mt19937_64 engine(seed);
    std::vector<GrainState> grains;
    const double pitch = extent.x() / columns;
    for (int i = 0; i < number; ++i)
    {
        GrainState grain;
        grain.shape = choice[static_cast<std::size_t>(uniform(engine) * static_cast<double>(choice.size()))];
        grain.angle = 2 * M_PI * uniform(engine);
        // Room that the grain leaves in its place is used at random: a lattice of equal grains would fall as columns.
        const double room = pitch - 2 * boundingRadius(shapes[static_cast<std::size_t>(grain.shape)].shape);
        const double shift = room * (uniform(engine) - 0.5);
        grain.position =
            box.lower + Vector2((i % columns + 0.5) * pitch + shift, (i / columns + 0.5) * widest);
        grains.push_back(grain);
    }
    return grains;
}

} // namespace chesil
