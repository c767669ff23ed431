#pragma once

#include "core/base/pairKey.hpp"
#include "core/broadphase/hierarchicalGrid.hpp"

#include <cstdint>
#include <vector>

namespace chesil
{

/// Pairs of grains (i < j) whose axis-aligned boxes, grown by half of the margin on each side, overlap, and
/// whose bounding circles come within `margin` of each other; sorted by i, then j, so that forces are summed
/// in one order on any run.
///
/// Each grain looks for partners in the grid of grains of its extent and in the grids of wider ones, so that
/// time and memory are linear in grains and pairs for any mixture of sizes and any spread over the plane.
/// What find returns is the caller's until the next search: it may be lengthened.
/// (Grains beyond 10^12 cells from the origin are right, but slow.) Buffers are kept from call to call.
class NeighbourSearch
{
public:
    /// Centres [m], half-extents of the boxes about them in x and y [m] (none: the radii), radii of the bounding circles about
    /// them [m], entry i for grain i; margin [m]. All but the centres are not negative. A grain with a number
    /// that is not finite has no neighbours.
    std::vector<PairKey>& find(const std::vector<Vector2>& positions,
                                  const std::vector<Vector2>& halfExtents, const std::vector<double>& radii,
                                  double margin);

    /// The same with all images in a periodic cell. ValueError if a width of the cell is not more than twice the reach of two
    /// grains of the largest radius with the margin, since a pair could meet by two images then, and if a
    /// position is farther than 60 lattice vectors from the cell.
    std::vector<PairKey>& find(const std::vector<Vector2>& positions,
                                  const std::vector<Vector2>& halfExtents, const std::vector<double>& radii,
                                  double margin, const PeriodicCell& cell);

    /// Memory that the buffers hold [bytes].
    std::size_t bytes() const;

private:
    using Entry = HierarchicalGrid::Entry;
    using Level = HierarchicalGrid::Level;

    template <bool images>
    std::vector<PairKey>& findAll(std::size_t grains);
    template <bool images>
    void findWithin(const Level& level);
    template <bool images>
    void findAcross(const Level& finer, const Level& coarser);
    template <bool across, bool images>
    void meet(const Entry& entry, std::size_t begin, std::size_t end);
    void order(std::size_t grains);

    HierarchicalGrid grids_;
    /// While they are looked for, the first `count_` are found; what stands behind them is of no meaning.
    std::vector<PairKey> pairs_;
    std::size_t count_ = 0;
    std::vector<std::uint32_t> ends_;
    std::vector<std::uint32_t> endsInBlock_;
};

} // namespace chesil
