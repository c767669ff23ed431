#pragma once

#include "core/base/periodicCell.hpp"
#include "core/base/vector.hpp"
#include "core/broadphase/foldedGrid.hpp"

#include <cstdint>
#include <vector>

namespace chesil
{

/// Grains sorted into grids by their extent, to a factor of two, each grid with cells as wide and as high as
/// any of its grains' boxes or those of finer grids; boxes and circles are grown by half of the margin. With
/// a periodic cell: each grain as its image in the cell, and ghosts, images in strips along the cell's sides.
class HierarchicalGrid
{
public:
    /// Centres [m], half-extents of the boxes about them [m] (none: the radii), radii of bounding circles about them
    /// [m], entry i for grain i; margin [m]. All but the centres are not negative.
    struct Scene
    {
        const std::vector<Vector2>& positions;
        const std::vector<Vector2>& halfExtents;
        const std::vector<double>& radii;
        double margin;

        Vector2 halfExtent(std::size_t i) const
        {
            return halfExtents.empty() ? Vector2(radii[i], radii[i]) : halfExtents[i];
        }
    };

    /// A grain or an image of one: position, half-extents and radius [m], the latter ones grown.
    struct Entry
    {
        double x;
        double y;
        double halfX;
        double halfY;
        double radius;
        std::int32_t grain;
        NearShift shift;
        bool ghost;
    };

    /// A grid and what its grains have in common.
    struct Level
    {
        std::size_t grains = 0;
        /// Widest grown box and circle [m].
        double halfX = 0;
        double halfY = 0;
        double radius = 0;
        FoldedGrid grid{0, 0, 0};
        std::size_t firstBucket = 0;
    };

    /// Leaves out grains with a number that is not finite.
    void fill(const Scene& scene);

    /// Ghosts are all the images that a grain of the same level or a finer one in the cell may meet.
    /// ValueError as NeighbourSearch::find says.
    void fill(const Scene& scene, const PeriodicCell& cell);

    /// From the widest to the finest, each with a grain.
    const std::vector<Level>& levels() const { return levels_; }

    /// By bucket, then by grain. Behind each grid stand copies of its first two buckets, so that what lies
    /// side by side on the ring does so in memory.
    const std::vector<Entry>& entries() const { return entries_; }

    /// Number of a bucket's first entry, by Level::firstBucket + bucket; the next one's is its end.
    std::size_t startOf(std::size_t bucket) const { return starts_[bucket]; }

    /// Memory that the buffers hold [bytes].
    std::size_t bytes() const;

private:
    /// An entry to be.
    struct Item
    {
        std::int32_t grain;
        std::uint32_t bucket;
        NearShift shift;
        bool ghost;
    };

    double widestOf(const Scene& scene);
    void sortIntoLevels(const Scene& scene);
    void layOutGrids();
    void placeImages(const Scene& scene, const PeriodicCell& cell);
    void placeGhosts(Item ghost, const Vector2& position, const Vector2& fraction, const Vector2& strips,
                     const PeriodicCell& cell);
    void place(Item item, const Vector2& position);
    void sortIntoBuckets(const Scene& scene, const PeriodicCell* cell);
    void copyFirstBuckets();
    void requireWide(const PeriodicCell& cell) const;

    std::vector<Level> levels_;
    std::vector<std::int8_t> levelOf_;
    std::vector<Item> items_;
    std::vector<std::uint32_t> starts_;
    std::vector<Entry> entries_;
};

} // namespace chesil
