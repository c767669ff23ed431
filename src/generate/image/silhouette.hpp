#pragma once

#include "core/base/vector.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace chesil
{

/// The pixels of one grain, in the box around them. Frame: origin at the lower left corner of the box, x to
/// the right, y *up* (images are stored from the top down, hence the reader turns them over), one pixel
/// is one unit, pixel (x, y) covers [x, x+1] x [y, y+1].
class Silhouette
{
public:
    /// `pixels`: width * height values, bottom row first; not zero is dark.
    Silhouette(int width, int height, std::vector<std::uint8_t> pixels,
               const Vector2& corner = Vector2::Zero())
        : width_(width), height_(height), pixels_(std::move(pixels)), corner_(corner)
    {
        for (const std::uint8_t pixel : pixels_)
        {
            count_ += pixel != 0;
        }
    }

    int width() const { return width_; }
    int height() const { return height_; }

    /// Number of dark pixels.
    int count() const { return count_; }

    /// Lower left corner of the box in the image's frame [pixel], origin at the image's lower left corner, y
    /// up.
    const Vector2& corner() const { return corner_; }

    /// False outside the box.
    bool dark(int x, int y) const
    {
        return x >= 0 && x < width_ && y >= 0 && y < height_ &&
               pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(x)] != 0;
    }

private:
    int width_;
    int height_;
    std::vector<std::uint8_t> pixels_;
    Vector2 corner_;
    int count_ = 0;
};

} // namespace chesil
