#pragma once

#include "core/base/randomNumbers.hpp"
#include "core/shapes/shape.hpp"
#include "core/world/sizeDistribution.hpp"

#include <vector>

namespace chesil
{

/// A shape (index) and its proportion of the grains' number, > 0; proportions may have any sum.
struct ShapeShare
{
    int shape = 0;
    double share = 0;
};

/// What grains are made of: shapes and sizes, independent of each other.
struct Composition
{
    std::vector<ShapeShare> mixture;
    SizeClasses sizes;
};

/// The shape of each of `number` grains, in random order. Shapes, and classes of size, come in their shares:
/// any run of them in the order given holds its share of the number to within one grain (systematic
/// sampling). A shape in a size that is not its own is appended to `shapes`, once however many grains have
/// it. Throws ValueError for a size that no shape may have.
std::vector<int> composeNumber(std::vector<NamedShape>& shapes, const Composition& composition, int number,
                               RandomEngine& engine);

/// The same for grains of `area` [m2] in all: as many as have that area on average, then some left out or
/// doubled until it is met to within the area of the smallest. Throws ValueError, too, if that is none, or
/// more than an int can count.
std::vector<int> composeArea(std::vector<NamedShape>& shapes, const Composition& composition, double area,
                             RandomEngine& engine);

} // namespace chesil
