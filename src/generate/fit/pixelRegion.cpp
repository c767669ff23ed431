#include "generate/fit/pixelRegion.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

namespace
{

/// Number of pixels from an odd to an even bound.
int oddCount(const std::vector<int>& sortedBounds)
{
    int count = 0;
    for (std::size_t i = 0; i + 1 < sortedBounds.size(); i += 2)
    {
        count += sortedBounds[i + 1] - sortedBounds[i];
    }
    return count;
}

/// The first pixel whose centre is not below the coordinate.
int firstPixel(double coordinate) { return static_cast<int>(std::ceil(coordinate - 0.5)); }

} // namespace

PixelRegion::PixelRegion(const Silhouette& silhouette)
{
    for (int y = 0; y < silhouette.height(); ++y)
    {
        std::vector<int> row;
        for (int x = 0; x <= silhouette.width(); ++x)
        {
            if (silhouette.dark(x, y) != silhouette.dark(x - 1, y))
            {
                row.push_back(x);
            }
        }
        runs_.push_back(std::move(row));
    }
}

PixelRegion::PixelRegion(const std::vector<Vector2>& polygon)
{
    double lowest = polygon.front().y();
    double highest = lowest;
    for (const Vector2& vertex : polygon)
    {
        lowest = std::min(lowest, vertex.y());
        highest = std::max(highest, vertex.y());
    }
    firstRow_ = firstPixel(lowest);
    runs_.resize(static_cast<std::size_t>(firstPixel(highest) - firstRow_));

    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        Vector2 low = polygon[i];
        Vector2 high = polygon[(i + 1) % polygon.size()];
        if (low.y() > high.y())
        {
            std::swap(low, high);
        }
        for (int row = firstPixel(low.y()); row < firstPixel(high.y()); ++row)
        {
            const double share = (row + 0.5 - low.y()) / (high.y() - low.y());
            const double crossing = low.x() + share * (high.x() - low.x());
            runs_[static_cast<std::size_t>(row - firstRow_)].push_back(firstPixel(crossing));
        }
    }
    for (std::vector<int>& row : runs_)
    {
        std::sort(row.begin(), row.end());
    }
}

int PixelRegion::count() const
{
    int count = 0;
    for (const std::vector<int>& row : runs_)
    {
        count += oddCount(row);
    }
    return count;
}

int PixelRegion::differing(const PixelRegion& a, const PixelRegion& b)
{
    const auto end = [](const PixelRegion& region)
    { return region.firstRow_ + static_cast<int>(region.runs_.size()); };
    int count = 0;
    std::vector<int> merged;
    for (int y = std::min(a.firstRow_, b.firstRow_); y < std::max(end(a), end(b)); ++y)
    {
        merged.clear();
        for (const PixelRegion* region : {&a, &b})
        {
            if (y >= region->firstRow_ && y < end(*region))
            {
                const auto& row = region->runs_[static_cast<std::size_t>(y - region->firstRow_)];
                merged.insert(merged.end(), row.begin(), row.end());
            }
        }
        std::sort(merged.begin(), merged.end());
        count += oddCount(merged);
    }
    return count;
}

double fitAccuracy(const PixelRegion& fitted, const PixelRegion& shape)
{
    return 1 - static_cast<double>(PixelRegion::differing(fitted, shape)) / shape.count();
}

} // namespace chesil
