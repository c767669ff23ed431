#pragma once

#include <optional>
#include <vector>

namespace chesil
{

/// How densely grains fill a region.
struct Packing
{
    /// Grains' area over the region's. Overlaps are not subtracted: it comes out too large by the overlaps'
    /// share, and above 1 if grains overlap enough.
    double solidFraction = 0;
    /// Area of the voids over that of the grains, by the same count, hence negative where the solid fraction
    /// is above 1; nothing without grains.
    std::optional<double> voidRatio;
};

/// From the grains' areas [m2] and that of the region that holds them all [m2]; a grain that the region cuts
/// counts as the caller gives it. Throws ValueError if the region's area is not positive and finite, or a
/// grain's is negative or not finite.
Packing packing(const std::vector<double>& grainAreas, double regionArea);

} // namespace chesil
