#pragma once

#include "core/base/randomNumbers.hpp"
#include "core/world/worldSettings.hpp"

#include <cstdint>
#include <vector>

namespace chesil
{

/// An upright rectangle in the world's frame [m].
struct PlacementBox
{
    Vector2 lower;
    Vector2 upper;
};

/// Throws ValueError unless the box has a finite width and height > 0.
void requireExtent(const PlacementBox& box);

/// `number` grains on a square lattice in the box, filled row by row from below; shape and angle of each
/// drawn at random (seeded, the same on any machine), the lattice as wide as the widest shape, so that none
/// overlap. Throws ValueError if the widest shape does not fit into the box, or the box holds fewer places.
std::vector<GrainState> placeOnLattice(const std::vector<NamedShape>& shapes, const std::vector<int>& choice,
                                       int number, const PlacementBox& box, std::uint64_t seed);

/// The same for grains whose shapes are drawn already: entry i for grain i.
std::vector<GrainState> placeOnLattice(const std::vector<NamedShape>& shapes,
                                       const std::vector<int>& shapeOfGrain, const PlacementBox& box,
                                       RandomEngine& engine);

/// Numbers grains anew, row by row as a lattice is, so that those near each other have near numbers: a step of 10^6 disks
/// is five times faster than in random order (benchmark dryLinearity). Positions must be finite.
void numberByPlace(std::vector<GrainState>& grains);

} // namespace chesil
