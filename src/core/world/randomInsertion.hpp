#pragma once

#include "core/world/placement.hpp"

#include <vector>

namespace chesil
{

/// How often a grain is tried at a new place and angle before the box counts as full. 10^4 equal disks at a
/// solid fraction of 0.5 take 60 tries on average and 10^4 at most; beyond 0.547 they never find a place
/// (Feder, J. Theor. Biol. 87 (1980) 237).
constexpr int triesForPlace = 100000;

/// Grains (entry i of `shapeOfGrain` for each) at random positions and angles, their outlines within the box
/// and at least `gap` [m] apart; the exact distance decides. Random sequential insertion, largest bounding
/// radius first; numbered by place. Throws ValueError if the box is empty, gap is negative or not
/// finite, or a grain finds no place in `triesForPlace` tries. Method: Widom, J. Chem. Phys. 44 (1966) 3888.
std::vector<GrainState> insertAtRandom(const std::vector<NamedShape>& shapes,
                                       const std::vector<int>& shapeOfGrain, const PlacementBox& box,
                                       double gap, RandomEngine& engine);

} // namespace chesil
