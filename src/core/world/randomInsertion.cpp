#include "core/world/randomInsertion.hpp"

#include "core/base/setupError.hpp"
#include "core/world/pairDistance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace chesil
{

namespace
{

void requireGap(double gap)
{
    if (!(gap >= 0 && std::isfinite(gap)))
    {
        throw ValueError("a gap of " + numberText(gap) + " m", "a finite gap >= 0");
    }
}

/// Grains placed so far, each known to all cells that its bounding square meets. Cells as many as grains: the
/// bigger grains fill many cells and the smaller ones share few, whatever the ratio of their sizes.
class PlacedGrains
{
public:
    PlacedGrains(const std::vector<NamedShape>& shapes, const PlacementBox& box, double gap,
                 std::size_t number)
        : shapes_(shapes), box_(box), gap_(gap)
    {
        const Vector2 extent = box.upper - box.lower;
        const auto count = static_cast<double>(number);
        // In a long, low box the second bound keeps the cells from being many more than the grains.
        width_ = std::max(std::sqrt(extent.x() / count) * std::sqrt(extent.y()), extent.maxCoeff() / count);
        columns_ = static_cast<std::int64_t>(extent.x() / width_) + 1;
        rows_ = static_cast<std::int64_t>(extent.y() / width_) + 1;
        cells_.resize(static_cast<std::size_t>(columns_ * rows_));
    }

    void add(const GrainState& grain, const Pose<2>& pose)
    {
        const double radius = radiusOf(grain);
        const CellRange range = cellsWithin(grain.position, radius);
        const auto index = static_cast<std::uint32_t>(grains_.size());
        for (std::int64_t row = range.firstRow; row <= range.lastRow; ++row)
        {
            for (std::int64_t column = range.firstColumn; column <= range.lastColumn; ++column)
            {
                cellAt(column, row).push_back(index);
            }
        }
        grains_.push_back(grain);
        poses_.push_back(pose);
        radii_.push_back(radius);
        ranges_.push_back(range);
    }

    bool isFree(const GrainState& grain, const Pose<2>& pose) const
    {
        const double radius = radiusOf(grain);
        const CellRange range = cellsWithin(grain.position, radius + gap_);
        for (std::int64_t row = range.firstRow; row <= range.lastRow; ++row)
        {
            for (std::int64_t column = range.firstColumn; column <= range.lastColumn; ++column)
            {
                for (const std::uint32_t other : cellAt(column, row))
                {
                    // Of the cells that both meet, the first one asks.
                    const bool first = column == std::max(range.firstColumn, ranges_[other].firstColumn) &&
                                       row == std::max(range.firstRow, ranges_[other].firstRow);
                    if (first && !areApart(grain, pose, radius, other))
                    {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    const std::vector<GrainState>& grains() const { return grains_; }

    double area() const
    {
        double sum = 0;
        for (const GrainState& grain : grains_)
        {
            sum += massProperties(shapeOf(grain)).area;
        }
        return sum;
    }

private:
    using Cell = std::vector<std::uint32_t>;

    struct CellRange
    {
        std::int64_t firstColumn;
        std::int64_t lastColumn;
        std::int64_t firstRow;
        std::int64_t lastRow;
    };

    const Shape& shapeOf(const GrainState& grain) const
    {
        return shapes_[static_cast<std::size_t>(grain.shape)].shape;
    }
    double radiusOf(const GrainState& grain) const { return boundingRadius(shapeOf(grain)); }

    Cell& cellAt(std::int64_t column, std::int64_t row)
    {
        return cells_[static_cast<std::size_t>(row * columns_ + column)];
    }
    const Cell& cellAt(std::int64_t column, std::int64_t row) const
    {
        return cells_[static_cast<std::size_t>(row * columns_ + column)];
    }

    std::int64_t cellOf(double along, std::int64_t count) const
    {
        return static_cast<std::int64_t>(std::clamp(along / width_, 0.0, static_cast<double>(count - 1)));
    }

    CellRange cellsWithin(const Vector2& position, double reach) const
    {
        const Vector2 local = position - box_.lower;
        return {cellOf(local.x() - reach, columns_), cellOf(local.x() + reach, columns_),
                cellOf(local.y() - reach, rows_), cellOf(local.y() + reach, rows_)};
    }

    bool areApart(const GrainState& grain, const Pose<2>& pose, double radius, std::uint32_t other) const
    {
        const double clear = radius + radii_[other] + gap_;
        if ((grain.position - poses_[other].position).squaredNorm() > clear * clear)
        {
            return true;
        }
        const PairDistance found = pairDistance(shapeOf(grain), pose, shapeOf(grains_[other]), poses_[other]);
        // A query that ended without an answer does not prove a free place.
        return found.status == PairStatus::separated && found.distance >= gap_;
    }

    const std::vector<NamedShape>& shapes_;
    PlacementBox box_;
    double gap_;
    double width_;
    std::int64_t columns_;
    std::int64_t rows_;
    std::vector<Cell> cells_;
    std::vector<GrainState> grains_;
    std::vector<Pose<2>> poses_;
    std::vector<double> radii_;
    std::vector<CellRange> ranges_;
};

/// Centroids at which the outline, turned so, lies within the box; none if it is too wide.
std::optional<PlacementBox> roomFor(const Shape& shape, const Rotation<2>& rotation, const PlacementBox& box)
{
    const auto reach = [&](const Vector2& direction)
    { return rotation.apply(support(shape, rotation.applyInverse(direction))).dot(direction); };
    const Vector2 low(reach(-Vector2::UnitX()), reach(-Vector2::UnitY()));
    const Vector2 high(reach(Vector2::UnitX()), reach(Vector2::UnitY()));
    const PlacementBox room{box.lower + low, box.upper - high};
    const bool fits = room.lower.x() <= room.upper.x() && room.lower.y() <= room.upper.y();
    return fits ? std::optional<PlacementBox>(room) : std::nullopt;
}

/// Whether a place was found for a grain of the shape.
bool insert(PlacedGrains& placed, int index, const Shape& shape, const PlacementBox& box,
            RandomEngine& engine)
{
    GrainState grain;
    grain.shape = index;
    for (int i = 0; i < triesForPlace; ++i)
    {
        grain.angle = 2 * M_PI * uniform(engine);
        const Rotation<2> rotation(grain.angle);
        const double across = uniform(engine);
        const double up = uniform(engine);
        const std::optional<PlacementBox> room = roomFor(shape, rotation, box);
        if (!room)
        {
            continue;
        }
        grain.position = room->lower + Vector2(across, up).cwiseProduct(room->upper - room->lower);
        const Pose<2> pose{grain.position, rotation};
        if (placed.isFree(grain, pose))
        {
            placed.add(grain, pose);
            return true;
        }
    }
    return false;
}

[[noreturn]] void refuse(const PlacedGrains& placed, std::size_t number, const NamedShape& shape,
                         const PlacementBox& box)
{
    const Vector2 extent = box.upper - box.lower;
    throw ValueError("no place for grain " + shape.name + " in " + std::to_string(triesForPlace) +
                         " tries, with " + std::to_string(placed.grains().size()) + " of " +
                         std::to_string(number) + " grains placed, which fill " +
                         numberText(placed.area() / extent.x() / extent.y()) + " of the box",
                     "fewer or smaller grains, a bigger box or a smaller gap");
}

} // namespace

std::vector<GrainState> insertAtRandom(const std::vector<NamedShape>& shapes,
                                       const std::vector<int>& shapeOfGrain, const PlacementBox& box,
                                       double gap, RandomEngine& engine)
{
    requireExtent(box);
    requireGap(gap);
    const auto shapeAt = [&](int index) -> const NamedShape&
    { return shapes[static_cast<std::size_t>(index)]; };
    std::vector<int> order = shapeOfGrain;
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b)
                     { return boundingRadius(shapeAt(a).shape) > boundingRadius(shapeAt(b).shape); });
    PlacedGrains placed(shapes, box, gap, std::max<std::size_t>(1, order.size()));
    for (const int index : order)
    {
        if (!insert(placed, index, shapeAt(index).shape, box, engine))
        {
            refuse(placed, order.size(), shapeAt(index), box);
        }
    }
    std::vector<GrainState> grains = placed.grains();
    numberByPlace(grains);
    return grains;
}

} // namespace chesil
