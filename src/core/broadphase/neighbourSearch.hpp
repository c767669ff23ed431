#pragma once

#include "core/broadphase/hierarchicalGrid.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace chesil
{

/// Pairs of grains (i < j) whose axis-aligned boxes, grown by half of the margin on each side, overlap, and
/// whose bounding circles come within `margin` of each other; sorted by i, then j, so that forces are summed
/// in one order on any run.
///
/// Each grain looks for partners in the grid of grains of its extent and in the grids of wider ones, so that
/// time and memory are linear in grains and pairs for any mixture of sizes and any spread over the plane.
/// (Grains beyond 10^12 cells from the origin are right, but slow.) Buffers are kept from call to call.
class NeighbourSearch
{
public:
    using Pair = std::pair<std::int32_t, std::int32_t>;

    /// Centres [m], half-extents of the boxes about them in x and y [m], radii of the bounding circles about
    /// them [m], entry i for grain i; margin [m]. All but the centres are not negative. A grain with a number
    /// that is not finite has no neighbours.
    const std::vector<Pair>& find(const std::vector<Vector2>& positions,
                                  const std::vector<Vector2>& halfExtents, const std::vector<double>& radii,
                                  double margin);

    /// The same with all images in a periodic cell: grain j is near grain i as its image at positions[j] +
    /// offset(shift), see shifts(). ValueError if a width of the cell is not more than twice the reach of two
    /// grains of the largest radius with the margin, since a pair could meet by two images then, and if a
    /// position is farther than 60 lattice vectors from the cell.
    const std::vector<Pair>& find(const std::vector<Vector2>& positions,
                                  const std::vector<Vector2>& halfExtents, const std::vector<double>& radii,
                                  double margin, const PeriodicCell& cell);

    /// Entry k for pair k of the last search; empty if that was without a cell.
    const std::vector<NearShift>& shifts() const { return shifts_; }

    /// Memory that the buffers hold [bytes].
    std::size_t bytes() const;

private:
    using Entry = HierarchicalGrid::Entry;
    using Level = HierarchicalGrid::Level;

    struct ImagePair
    {
        std::int32_t first;
        std::int32_t second;
        NearShift shift;
    };

    template <class Found>
    void findAll(std::vector<Found>& found);
    template <class Found>
    void findWithin(const Level& level, std::vector<Found>& found);
    template <class Found>
    void findAcross(const Level& finer, const Level& coarser, std::vector<Found>& found);
    template <bool across, class Found>
    void meet(const Entry& entry, std::size_t begin, std::size_t end, std::vector<Found>& found);
    template <class Found>
    void order(const std::vector<Found>& found, std::size_t grains, std::vector<Found>& ordered);

    HierarchicalGrid grids_;
    /// The first `count_` are found; what stands behind them is of no meaning.
    std::vector<Pair> found_;
    std::vector<ImagePair> foundImages_;
    std::size_t count_ = 0;
    std::vector<std::size_t> firstOf_;
    std::vector<Pair> pairs_;
    std::vector<ImagePair> imagePairs_;
    std::vector<NearShift> shifts_;
};

} // namespace chesil
