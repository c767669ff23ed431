#include "generate/image/greyImage.hpp"

#include "core/base/setupError.hpp"
#include "generate/image/wholeTiff.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

namespace chesil
{

namespace
{

/// Lets Leptonica keep the 16 bits of a PNG, for as long as it lives.
class WholePngDepth
{
public:
    WholePngDepth() { l_pngSetReadStrip16To8(0); }
    ~WholePngDepth() { l_pngSetReadStrip16To8(1); }
    WholePngDepth(const WholePngDepth&) = delete;
    WholePngDepth& operator=(const WholePngDepth&) = delete;
};

std::string mostPixelsText() { return "at most " + std::to_string(mostPixels) + " pixels"; }

/// Leptonica does not tell which.
SetupError noImage(const std::string& path)
{
    return SetupError(path, "image", "no image, or one that is cut short, damaged or too large",
                      "a whole PNG, JPEG or TIFF image of " + mostPixelsText());
}

void requireSize(const std::string& path, long width, long height)
{
    if (width * height > mostPixels)
    {
        throw SetupError(path, "image", std::to_string(width) + " x " + std::to_string(height) + " pixels",
                         mostPixelsText() + ": cut it into parts");
    }
}

Owned<Pix> readAsStored(const std::string& path)
{
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file.good())
    {
        throw SetupError(path, "image", std::strerror(errno), "an image file that can be read");
    }
    l_int32 format = 0;
    l_int32 width = 0;
    l_int32 height = 0;
    l_int32 bits = 0;
    l_int32 samples = 0;
    l_int32 hasPalette = 0;
    if (pixReadHeader(path.c_str(), &format, &width, &height, &bits, &samples, &hasPalette) != 0 ||
        !isWholeTiff(path))
    {
        throw noImage(path);
    }
    requireSize(path, width, height);
    // Leptonica cannot hold 16 bits of several samples.
    Owned<Pix> stored;
    if (bits == 16 && samples == 1)
    {
        const WholePngDepth whole;
        stored.reset(pixRead(path.c_str()));
    }
    else
    {
        stored.reset(pixRead(path.c_str()));
    }
    if (!stored)
    {
        throw noImage(path);
    }
    return stored;
}

bool isGrey(Pix* colour)
{
    for (int y = 0; y < pixGetHeight(colour); ++y)
    {
        const l_uint32* row = pixGetData(colour) + static_cast<std::ptrdiff_t>(y) * pixGetWpl(colour);
        for (int x = 0; x < pixGetWidth(colour); ++x)
        {
            l_int32 red = 0;
            l_int32 green = 0;
            l_int32 blue = 0;
            extractRGBValues(row[x], &red, &green, &blue);
            if (red != green || green != blue)
            {
                return false;
            }
        }
    }
    return true;
}

/// To 8 bits, values kept, unlike Leptonica's own functions, which spread them over 0 to 255. In its images
/// of one bit black is 1.
Owned<Pix> widened(Pix* narrow, bool turnOver)
{
    Owned<Pix> wide(pixCreate(pixGetWidth(narrow), pixGetHeight(narrow), 8));
    for (int y = 0; wide && y < pixGetHeight(narrow); ++y)
    {
        for (int x = 0; x < pixGetWidth(narrow); ++x)
        {
            l_uint32 value = 0;
            pixGetPixel(narrow, x, y, &value);
            pixSetPixel(wide.get(), x, y, turnOver ? 1 - value : value);
        }
    }
    return wide;
}

} // namespace

GreyImage::GreyImage(Owned<Pix> pixels)
    : pixels_(std::move(pixels)), width_(pixGetWidth(pixels_.get())), height_(pixGetHeight(pixels_.get())),
      depth_(pixGetDepth(pixels_.get())), wordsPerRow_(pixGetWpl(pixels_.get())),
      data_(pixGetData(pixels_.get()))
{
}

GreyImage readGreyImage(const std::string& path, bool transparentIsBlack)
{
    Owned<Pix> image = readAsStored(path);
    if (pixGetSpp(image.get()) == 4)
    {
        image.reset(pixAlphaBlendUniform(image.get(), transparentIsBlack ? 0 : 0xffffff00));
    }
    if (image && pixGetDepth(image.get()) != 16)
    {
        image.reset(pixConvertTo8(image.get(), 0));
    }
    if (!image)
    {
        throw noImage(path);
    }
    return GreyImage(std::move(image));
}

GreyImage readLabelImage(const std::string& path)
{
    Owned<Pix> image = readAsStored(path);
    const bool hasPalette = pixGetColormap(image.get()) != nullptr;
    pixDestroyColormap(image.get());
    const int depth = pixGetDepth(image.get());
    if (depth == 32)
    {
        if (!isGrey(image.get()))
        {
            throw SetupError(path, "image", "colours",
                             "a label image: grey values of 8 or 16 bits, or a palette, one value a grain");
        }
        image.reset(pixGetRGBComponent(image.get(), COLOR_GREEN));
    }
    else if (depth < 8)
    {
        image = widened(image.get(), depth == 1 && !hasPalette);
    }
    if (!image)
    {
        throw noImage(path);
    }
    return GreyImage(std::move(image));
}

} // namespace chesil
