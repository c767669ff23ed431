#pragma once

#include "core/base/vector.hpp"
#include "generate/image/silhouette.hpp"

#include <vector>

namespace chesil
{

/// A set of pixels, kept as runs row by row, to compare shapes with each other as an image shows them: a
/// pixel belongs to a shape if its centre does. That is how a grain becomes a silhouette, hence a fit that is
/// the grain itself is found to have no pixel wrong (an area compared with the pixels' staircase would).
class PixelRegion
{
public:
    /// In the silhouette's frame.
    explicit PixelRegion(const Silhouette& silhouette);

    /// The pixels with their centre inside a simple polygon [pixel].
    explicit PixelRegion(const std::vector<Vector2>& polygon);

    int count() const;

    /// Number of pixels that are in one of the regions but not in both.
    static int differing(const PixelRegion& a, const PixelRegion& b);

private:
    /// Row `firstRow_ + k`: first pixel of a run, first pixel after it, and so on, rising.
    std::vector<std::vector<int>> runs_;
    int firstRow_ = 0;
};

/// 1 - (differing pixels) / (pixels of the shape): Lai & Huang, section 5.1.
double fitAccuracy(const PixelRegion& fitted, const PixelRegion& shape);

} // namespace chesil
