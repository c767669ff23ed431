#include "core/world/placement.hpp"

#include "core/base/setupError.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace chesil
{

namespace
{

struct Lattice
{
    PlacementBox box;
    /// Size of the widest shape [m].
    double widest;
    int columns;

    double pitch() const { return (box.upper.x() - box.lower.x()) / columns; }
};

/// Wide enough for each of the shapes, with places for `number` grains.
Lattice latticeFor(const std::vector<NamedShape>& shapes, const std::vector<int>& used, std::size_t number,
                   const PlacementBox& box)
{
    double widest = 0;
    std::string name;
    for (const int index : used)
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
        throw ValueError("a box of " + numberText(extent.x()) + " x " + numberText(extent.y()) +
                             " m for grain " + name + ", " + numberText(widest) + " m wide",
                         "a box wider than its grains");
    }
    const int columns = static_cast<int>(extent.x() / widest);
    const int rows = static_cast<int>(extent.y() / widest);
    if (static_cast<double>(columns) * rows < static_cast<double>(number))
    {
        throw ValueError(std::to_string(number) + " grains in a box with " + std::to_string(columns) + " x " +
                             std::to_string(rows) + " places of " + numberText(widest) + " m",
                         "fewer grains, or a higher box");
    }
    return {box, widest, columns};
}

GrainState grainAt(std::size_t place, int shape, const std::vector<NamedShape>& shapes,
                   const Lattice& lattice, RandomEngine& engine)
{
    GrainState grain;
    grain.shape = shape;
    grain.angle = 2 * M_PI * uniform(engine);
    // Room that the grain leaves in its place is used at random: a lattice of equal grains would fall as
    // columns.
    const double room = lattice.pitch() - 2 * boundingRadius(shapes[static_cast<std::size_t>(shape)].shape);
    const double shift = room * (uniform(engine) - 0.5);
    const auto columns = static_cast<std::size_t>(lattice.columns);
    const auto column = static_cast<double>(place % columns);
    const auto row = static_cast<double>(place / columns);
    grain.position =
        lattice.box.lower + Vector2((column + 0.5) * lattice.pitch() + shift, (row + 0.5) * lattice.widest);
    return grain;
}

} // namespace

void requireExtent(const PlacementBox& box)
{
    const Vector2 extent = box.upper - box.lower;
    if (!(extent.x() > 0 && extent.y() > 0 && std::isfinite(extent.x() + extent.y())))
    {
        throw ValueError("a box of " + numberText(extent.x()) + " x " + numberText(extent.y()) + " m",
                         "an upper corner right of and above the lower one");
    }
}

std::vector<GrainState> placeOnLattice(const std::vector<NamedShape>& shapes, const std::vector<int>& choice,
                                       int number, const PlacementBox& box, std::uint64_t seed)
{
    const auto size = static_cast<std::size_t>(number);
    const Lattice lattice = latticeFor(shapes, choice, size, box);
    RandomEngine engine(seed);
    std::vector<GrainState> grains;
    for (std::size_t i = 0; i < size; ++i)
    {
        const int shape = choice[randomIndex(engine, choice.size())];
        grains.push_back(grainAt(i, shape, shapes, lattice, engine));
    }
    return grains;
}

std::vector<GrainState> placeOnLattice(const std::vector<NamedShape>& shapes,
                                       const std::vector<int>& shapeOfGrain, const PlacementBox& box,
                                       RandomEngine& engine)
{
    const Lattice lattice = latticeFor(shapes, shapeOfGrain, shapeOfGrain.size(), box);
    std::vector<GrainState> grains;
    for (std::size_t i = 0; i < shapeOfGrain.size(); ++i)
    {
        grains.push_back(grainAt(i, shapeOfGrain[i], shapes, lattice, engine));
    }
    return grains;
}

void numberByPlace(std::vector<GrainState>& grains)
{
    if (grains.empty())
    {
        return;
    }
    Vector2 lower = grains.front().position;
    Vector2 upper = lower;
    for (const GrainState& grain : grains)
    {
        lower = lower.cwiseMin(grain.position);
        upper = upper.cwiseMax(grain.position);
    }
    const Vector2 extent = upper - lower;
    // As many rows as if the grains stood on a square lattice.
    const double height = std::max(std::sqrt(extent.x() * extent.y() / static_cast<double>(grains.size())),
                                   extent.y() / static_cast<double>(grains.size()));
    const auto rowOf = [&](const GrainState& grain)
    { return height > 0 ? std::floor((grain.position.y() - lower.y()) / height) : 0; };
    std::stable_sort(
        grains.begin(), grains.end(),
        [&](const GrainState& a, const GrainState& b)
        {
            const double rowA = rowOf(a);
            const double rowB = rowOf(b);
            return rowA != rowB ? rowA < rowB : a.position.x() < b.position.x();
        });
}

} // namespace chesil
