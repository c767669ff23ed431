#include "core/broadphase/hierarchicalGrid.hpp"

#include "core/base/roomToGrow.hpp"
#include "core/base/setupError.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace chesil
{

namespace
{

/// Grains 2^-23 times as wide as the widest one and finer ones share the last grid.
constexpr int mostLevels = 24;
constexpr std::int8_t noLevel = -1;

/// Lattice vectors that a position may be off the cell, so that differences fit NearShift.
constexpr double mostCellsAway = 3;

/// Covers rounding where a distance is compared in parts of the lattice vectors.
constexpr double roundingSlack = 1 + 1e-9;

} // namespace

void HierarchicalGrid::fill(const Scene& scene)
{
    sortIntoLevels(scene);
    layOutGrids();
    for (std::size_t i = 0; i < scene.positions.size(); ++i)
    {
        if (levelOf_[i] != noLevel)
        {
            place({static_cast<std::int32_t>(i), 0, {}, false}, scene.positions[i]);
        }
    }
    sortIntoBuckets(scene, nullptr);
}

void HierarchicalGrid::fill(const Scene& scene, const PeriodicCell& cell)
{
    sortIntoLevels(scene);
    requireWide(cell);
    layOutGrids();
    placeImages(scene, cell);
    sortIntoBuckets(scene, &cell);
}

std::size_t HierarchicalGrid::bytes() const
{
    const auto of = [](const auto& buffer) { return buffer.capacity() * sizeof(buffer[0]); };
    return of(levels_) + of(levelOf_) + of(items_) + of(starts_) + of(entries_);
}

/// Largest half-extent of all finite grains, which get a level, if not the right one yet.
double HierarchicalGrid::widestOf(const Scene& scene)
{
    levelOf_.assign(scene.positions.size(), noLevel);
    double widest = 0;
    for (std::size_t i = 0; i < scene.positions.size(); ++i)
    {
        const Vector2& position = scene.positions[i];
        const Vector2 half = scene.halfExtent(i);
        if (std::isfinite(0 * position.x() + 0 * position.y() + half.x() + half.y() + scene.radii[i]))
        {
            levelOf_[i] = 0;
            widest = std::max(widest, std::max(half.x(), half.y()));
        }
    }
    return widest;
}

void HierarchicalGrid::sortIntoLevels(const Scene& scene)
{
    const double growth = scene.margin / 2;
    const double widest = widestOf(scene) + growth;
    std::array<Level, mostLevels> all;
    for (std::size_t i = 0; i < scene.positions.size(); ++i)
    {
        if (levelOf_[i] == noLevel)
        {
            continue;
        }
        const Vector2 grown = scene.halfExtent(i) + Vector2(growth, growth);
        const double half = grown.maxCoeff();
        const int halvings = 2 * half >= widest ? 0 : std::min(std::ilogb(widest / half), mostLevels - 1);
        levelOf_[i] = static_cast<std::int8_t>(halvings);
        Level& level = all[static_cast<std::size_t>(halvings)];
        ++level.grains;
        level.halfX = std::max(level.halfX, grown.x());
        level.halfY = std::max(level.halfY, grown.y());
        level.radius = std::max(level.radius, scene.radii[i] + growth);
    }

    levels_.clear();
    std::array<std::int8_t, mostLevels> numberOf{};
    for (std::size_t k = 0; k < all.size(); ++k)
    {
        if (all[k].grains > 0)
        {
            numberOf[k] = static_cast<std::int8_t>(levels_.size());
            levels_.push_back(all[k]);
        }
    }
    for (std::int8_t& level : levelOf_)
    {
        level = level == noLevel ? noLevel : numberOf[static_cast<std::size_t>(level)];
    }
}

void HierarchicalGrid::requireWide(const PeriodicCell& cell) const
{
    double radius = 0;
    for (const Level& level : levels_)
    {
        radius = std::max(radius, level.radius);
    }
    const Vector2 widths = cell.widths();
    if (!levels_.empty() && !(widths.minCoeff() > 4 * radius))
    {
        throw ValueError("a periodic cell " + numberText(widths.x()) + " and " + numberText(widths.y()) +
                             " m wide across its sides",
                         "more than " + numberText(4 * radius) +
                             " m, twice the reach of two grains of the largest radius with their margin");
    }
}

void HierarchicalGrid::layOutGrids()
{
    // As wide and high as boxes of finer grids, too: these look at no more than three columns and rows, then.
    double halfX = 0;
    double halfY = 0;
    for (auto level = levels_.rbegin(); level != levels_.rend(); ++level)
    {
        halfX = std::max(halfX, level->halfX);
        halfY = std::max(halfY, level->halfY);
        level->grid = FoldedGrid(2 * halfX * FoldedGrid::slack, 2 * halfY * FoldedGrid::slack, level->grains);
    }
    std::size_t bucket = 0;
    for (Level& level : levels_)
    {
        level.firstBucket = bucket;
        bucket += level.grid.size() + 2;
    }
    starts_.assign(bucket + 2, 0);
    items_.clear();
    makeRoom(items_, levelOf_.size());
}

void HierarchicalGrid::place(Item item, const Vector2& position)
{
    const Level& level = levels_[static_cast<std::size_t>(levelOf_[static_cast<std::size_t>(item.grain)])];
    const std::int64_t column = level.grid.columnOf(position.x());
    const std::int64_t row = level.grid.rowOf(position.y());
    item.bucket = static_cast<std::uint32_t>(level.firstBucket) + level.grid.bucketOf(column, row);
    items_.push_back(item);
    // Two further on, where sortIntoBuckets wants the count.
    ++starts_[item.bucket + 2];
}

void HierarchicalGrid::placeImages(const Scene& scene, const PeriodicCell& cell)
{
    // A pair of two levels is found by the finer grain, and so needs no ghosts of that.
    std::array<double, mostLevels> widestMet{};
    for (std::size_t k = levels_.size(); k-- > 0;)
    {
        widestMet[k] = std::max(levels_[k].radius, k + 1 < levels_.size() ? widestMet[k + 1] : 0);
    }
    const Vector2 inverseWidths = cell.widths().cwiseInverse();
    for (std::size_t i = 0; i < scene.positions.size(); ++i)
    {
        if (levelOf_[i] == noLevel)
        {
            continue;
        }
        const Vector2 fraction = cell.fractionOf(scene.positions[i]);
        const Vector2 cells(std::floor(fraction.x()), std::floor(fraction.y()));
        if (!(cells.cwiseAbs().maxCoeff() <= mostCellsAway))
        {
            throw ValueError(
                "grain " + std::to_string(i) + " at " + numberText(fraction.x()) + " and " +
                    numberText(fraction.y()) + " lattice vectors from the periodic cell's corner",
                "positions wrapped into the cell, or within " + numberText(mostCellsAway) + " of it");
        }
        const NearShift shift(-static_cast<int>(cells.x()), -static_cast<int>(cells.y()));
        const Item real{static_cast<std::int32_t>(i), 0, shift, false};
        place(real, scene.positions[i] + cell.offset(shift));
        const double met = widestMet[static_cast<std::size_t>(levelOf_[i])];
        const double reach = (scene.radii[i] + scene.margin / 2 + met) * roundingSlack;
        placeGhosts(real, scene.positions[i], fraction - cells, reach * inverseWidths, cell);
    }
}

/// `fraction` is that of the image in the cell, `strips` how far ghosts may be off the cell, in parts of the
/// lattice vectors: less than half of them, since the cell is wide enough.
void HierarchicalGrid::placeGhosts(Item ghost, const Vector2& position, const Vector2& fraction,
                                   const Vector2& strips, const PeriodicCell& cell)
{
    const NearShift real = ghost.shift;
    ghost.ghost = true;
    const auto reachesBack = [&](int side)
    { return strips[side] > 0 && fraction[side] - 1 >= -strips[side]; };
    const auto reachesOn = [&](int side) { return strips[side] > 0 && fraction[side] <= strips[side]; };
    for (int first = -reachesBack(0); first <= reachesOn(0); ++first)
    {
        for (int second = -reachesBack(1); second <= reachesOn(1); ++second)
        {
            if (first != 0 || second != 0)
            {
                ghost.shift = NearShift(real.first + first, real.second + second);
                place(ghost, position + cell.offset(ghost.shift));
            }
        }
    }
}

void HierarchicalGrid::sortIntoBuckets(const Scene& scene, const PeriodicCell* cell)
{
    for (const Level& level : levels_)
    {
        std::uint32_t* counts = starts_.data() + level.firstBucket + 2;
        counts[level.grid.size()] = counts[0];
        counts[level.grid.size() + 1] = counts[1];
    }
    for (std::size_t k = 1; k < starts_.size(); ++k)
    {
        starts_[k] += starts_[k - 1];
    }
    makeRoom(entries_, starts_.back());
    entries_.resize(starts_.back());
    // Now the start of each bucket stands one further on. Each entry counts it up, until it is the start of
    // the next.
    const double growth = scene.margin / 2;
    for (const Item& item : items_)
    {
        const auto i = static_cast<std::size_t>(item.grain);
        const Vector2 half = scene.halfExtent(i);
        Vector2 position = scene.positions[i];
        if (cell)
        {
            position += cell->offset(item.shift);
        }
        entries_[starts_[item.bucket + 1]++] = {
            position.x(), position.y(), half.x() + growth, half.y() + growth, scene.radii[i] + growth,
            item.grain,   item.shift,   item.ghost};
    }
    copyFirstBuckets();
}

void HierarchicalGrid::copyFirstBuckets()
{
    for (const Level& level : levels_)
    {
        const std::size_t end = level.firstBucket + level.grid.size();
        const auto at = [this](std::size_t start)
        { return entries_.begin() + static_cast<std::ptrdiff_t>(start); };
        const std::uint32_t first = starts_[level.firstBucket];
        const std::uint32_t second = starts_[level.firstBucket + 1];
        const std::uint32_t third = starts_[level.firstBucket + 2];
        std::copy(at(first), at(third), at(starts_[end]));
        starts_[end + 1] = starts_[end] + second - first;
        starts_[end + 2] = starts_[end] + third - first;
    }
}

} // namespace chesil
