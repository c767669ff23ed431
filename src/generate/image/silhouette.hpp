#pragma once

#include "core/base/vector.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace chesil
{

/// The pixels of one grain, in the box around them, and its outline at sub-pixel accuracy where the source
/// has one. Frame: origin at the lower left corner of the box, x to the right, y *up* (images are stored from
/// the top down, hence the reader turns them over), one pixel is one unit, pixel (x, y) covers [x, x+1] x [y,
/// y+1].
class Silhouette
{
public:
    /// `pixels`: width * height values, bottom row first; not zero is dark.
    Silhouette(int width, int height, const std::vector<std::uint8_t>& pixels,
               const Vector2& corner = Vector2::Zero())
        : width_(width), height_(height), pixels_(pixels.begin(), pixels.end()), corner_(corner)
    {
        count_ = static_cast<int>(std::count(pixels_.begin(), pixels_.end(), true));
    }

    int width() const { return width_; }
    int height() const { return height_; }

    /// Number of dark pixels.
    int count() const { return count_; }

    /// Lower left corner of the box in the image's frame [pixel], origin at the image's lower left corner, y
    /// up.
    const Vector2& corner() const { return corner_; }

    /// The grain's edge as a polygon without holes, counter-clockwise, in the silhouette's frame [pixel]; it
    /// may leave the box by up to half a pixel. Empty if nothing finer than the pixels is known.
    const std::vector<Vector2>& outline() const { return outline_; }
    void setOutline(std::vector<Vector2> outline) { outline_ = std::move(outline); }

    /// False outside the box.
    bool dark(int x, int y) const
    {
        return x >= 0 && x < width_ && y >= 0 && y < height_ &&
               pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(x)];
    }

private:
    int width_;
    int height_;
    /// A bit each: an image may hold ten thousand grains.
    std::vector<bool> pixels_;
    Vector2 corner_;
    std::vector<Vector2> outline_;
    int count_ = 0;
};

} // namespace chesil
