#include "core/broadphase/neighbourSearch.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace chesil
{

namespace
{

/// Covers rounding of the bounds between which wider grains are looked for.
constexpr double roundingSlack = 1 + 1e-12;

/// Pairs by a key below `keys`, in no order within a key: each is swapped to the end of its key's share (American flag
/// sort, McIlroy, Bostic & McIlroy 1993). Then calls then(begin, end, key) for each share in turn. `ends` is a buffer.
template <class KeyOf, class Then>
void sortInPlace(
    PairKey* begin, PairKey* const end, std::size_t keys, KeyOf keyOf, std::vector<std::uint32_t>& ends, Then then)
{
    ends.assign(keys, 0);
    std::for_each(begin, end, [&](const PairKey& pair) { ++ends[keyOf(pair)]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    PairKey* const first = begin;
    for (std::size_t key = 0; key < keys; ++key)
    {
        while (begin < first + ends[key])
        {
            std::swap(*begin, first[--ends[keyOf(*begin)]]);
        }
        PairKey* const next = std::find_if(begin, end, [&](const PairKey& pair) { return keyOf(pair) != key; });
        then(begin, next, key);
        begin = next;
    }
}

} // namespace

std::vector<PairKey>& NeighbourSearch::find(const std::vector<Vector2>& positions,
                                                                const std::vector<Vector2>& halfExtents,
                                                                const std::vector<double>& radii,
                                                                double margin)
{
    grids_.fill({positions, halfExtents, radii, margin});
    return findAll<false>(positions.size());
}

std::vector<PairKey>& NeighbourSearch::find(const std::vector<Vector2>& positions,
                                                                const std::vector<Vector2>& halfExtents,
                                                                const std::vector<double>& radii,
                                                                double margin, const PeriodicCell& cell)
{
    grids_.fill({positions, halfExtents, radii, margin}, cell);
    return findAll<true>(positions.size());
}

std::size_t NeighbourSearch::bytes() const
{
    const auto of = [](const auto& buffer) { return buffer.capacity() * sizeof(buffer[0]); };
    return grids_.bytes() + of(ends_) + of(endsInBlock_) + of(pairs_);
}

template <bool images>
std::vector<PairKey>& NeighbourSearch::findAll(std::size_t grains)
{
    count_ = 0;
    // As many as a dense packing has: buffers that are outgrown leave holes in the memory.
    pairs_.resize(std::max(pairs_.capacity(), 3 * grids_.entries().size()));
    const std::vector<Level>& levels = grids_.levels();
    for (std::size_t finer = 0; finer < levels.size(); ++finer)
    {
        findWithin<images>(levels[finer]);
        for (std::size_t coarser = 0; coarser < finer; ++coarser)
        {
            findAcross<images>(levels[finer], levels[coarser]);
        }
    }
    pairs_.resize(count_);
    order(grains);
    return pairs_;
}

/// Each bucket with itself, with the next one and with the three of the row ahead: all neighbours once.
template <bool images>
void NeighbourSearch::findWithin(const Level& level)
{
    for (std::uint32_t bucket = 0; bucket < level.grid.size(); ++bucket)
    {
        const std::size_t here = level.firstBucket + bucket;
        const std::size_t end = grids_.startOf(here + 1);
        const std::size_t endOfNext = grids_.startOf(here + 2);
        const std::size_t ahead = level.firstBucket + level.grid.aheadOf(bucket);
        for (std::size_t k = grids_.startOf(here); k < end; ++k)
        {
            const Entry& entry = grids_.entries()[k];
            meet<false, images>(entry, k + 1, endOfNext);
            meet<false, images>(entry, grids_.startOf(ahead), grids_.startOf(ahead + 3));
        }
    }
}

/// Boxes of a finer level and a coarser one that overlap have their centres within a coarser cell's width and
/// height: at most three columns and rows.
template <bool images>
void NeighbourSearch::findAcross(const Level& finer, const Level& coarser)
{
    const std::size_t end = grids_.startOf(finer.firstBucket + finer.grid.size());
    for (std::size_t k = grids_.startOf(finer.firstBucket); k < end; ++k)
    {
        const Entry& entry = grids_.entries()[k];
        if (entry.ghost)
        {
            continue;
        }
        const double reachX = (entry.halfX + coarser.halfX) * roundingSlack;
        const double reachY = (entry.halfY + coarser.halfY) * roundingSlack;
        const std::int64_t firstColumn = coarser.grid.columnOf(entry.x - reachX);
        const std::int64_t lastColumn = coarser.grid.columnOf(entry.x + reachX);
        const std::int64_t lastRow = coarser.grid.rowOf(entry.y + reachY);
        for (std::int64_t row = coarser.grid.rowOf(entry.y - reachY); row <= lastRow; ++row)
        {
            const std::size_t bucket = coarser.firstBucket + coarser.grid.bucketOf(firstColumn, row);
            const auto columns = static_cast<std::size_t>(lastColumn - firstColumn + 1);
            meet<true, images>(entry, grids_.startOf(bucket), grids_.startOf(bucket + columns));
        }
    }
}

/// Adds the pairs of an entry with the entries from `begin` to `end`. Every candidate is written down and
/// overwritten by the next if it was none: cheaper than a branch that is taken every other time.
template <bool across, bool images>
void NeighbourSearch::meet(const Entry& entry, std::size_t begin, std::size_t end)
{
    if (const std::size_t most = count_ + (end - begin); most > pairs_.size())
    {
        pairs_.reserve(most + most / 4);
        pairs_.resize(most + most / 4);
    }
    PairKey* next = pairs_.data() + count_;
    for (const Entry* other = grids_.entries().data() + begin; other != grids_.entries().data() + end;
         ++other)
    {
        const double x = other->x - entry.x;
        const double y = other->y - entry.y;
        const double reach = entry.radius + other->radius;
        bool near = (std::abs(x) <= entry.halfX + other->halfX) &
                    (std::abs(y) <= entry.halfY + other->halfY) & (x * x + y * y <= reach * reach);
        const bool ascending = entry.grain < other->grain;
        next->first = ascending ? entry.grain : other->grain;
        next->second = ascending ? other->grain : entry.grain;
        if constexpr (images)
        {
            const Entry& first = ascending ? entry : *other;
            const Entry& second = ascending ? *other : entry;
            next->shift = NearShift(second.shift.first - first.shift.first, second.shift.second - first.shift.second);
            // Within a level both grains have ghosts, and the pair is found twice. A grain's own ghost is
            // never near: the cell is too wide.
            near = near & (across | !first.ghost);
        }
        next += near;
    }
    count_ = static_cast<std::size_t>(next - pairs_.data());
}

/// In place, since a second list of pairs would be the largest buffer of a big scene: by blocks of grains, whose pairs stay
/// in the cache, then by the first grain, then by the second.
void NeighbourSearch::order(std::size_t grains)
{
    constexpr std::size_t block = 4096;
    const auto byFirst = [&](PairKey* begin, PairKey* end, std::size_t number)
    {
        const auto inBlock = [=](const PairKey& pair) { return static_cast<std::size_t>(pair.first) - number * block; };
        const auto bySecond = [](PairKey* from, PairKey* to, std::size_t)
        { std::sort(from, to, [](const PairKey& a, const PairKey& b) { return a.second < b.second; }); };
        sortInPlace(begin, end, std::min(block, grains - number * block), inBlock, endsInBlock_, bySecond);
    };
    const auto blockOf = [=](const PairKey& pair) { return static_cast<std::size_t>(pair.first) / block; };
    sortInPlace(pairs_.data(), pairs_.data() + count_, (grains + block - 1) / block, blockOf, ends_, byFirst);
}

} // namespace chesil
