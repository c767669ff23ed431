#pragma once

#include "generate/image/leptonicaHandles.hpp"

#include <string>

namespace chesil
{

/// Grey values of an image of 8 or 16 bits. Frame: pixel (0, 0) is the lower left one, y up.
class GreyImage
{
public:
    /// `pixels`: 8 or 16 bits a pixel, no palette.
    explicit GreyImage(Owned<Pix> pixels);

    int width() const { return width_; }
    int height() const { return height_; }

    /// Of white: 255 or 65535.
    int largest() const { return depth_ == 8 ? 255 : 65535; }

    /// The pixel must lie in the image.
    int value(int x, int y) const
    {
        const l_uint32* row = data_ + static_cast<std::ptrdiff_t>(height_ - 1 - y) * wordsPerRow_;
        return depth_ == 8 ? GET_DATA_BYTE(row, x) : GET_DATA_TWO_BYTES(row, x);
    }

    Pix* pixels() const { return pixels_.get(); }

private:
    Owned<Pix> pixels_;
    int width_;
    int height_;
    int depth_;
    int wordsPerRow_;
    const l_uint32* data_;
};

/// Most pixels of an image: beyond, the bytes of a colour image have no number that fits an int.
constexpr int mostPixels = (1 << 29) - 1;

/// Reads an image in any format Leptonica knows; colour and palettes become grey, 16 bits of grey stay. What
/// is transparent becomes black or white. Throws SetupError if the file cannot be read, is no image, is cut
/// short or too large.
GreyImage readGreyImage(const std::string& path, bool transparentIsBlack);

/// As readGreyImage, but the values are labels: the index into a palette where there is one, else the
/// grey value. Throws SetupError for colours, too.
GreyImage readLabelImage(const std::string& path);

} // namespace chesil
