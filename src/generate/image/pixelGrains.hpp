#pragma once

#include "generate/image/leptonicaHandles.hpp"
#include "generate/image/silhouetteReader.hpp"

#include <functional>

namespace chesil
{

/// A part of an image as a binary picture. Frame as in GreyImage.
struct BinaryPart
{
    Pix* pixels = nullptr;
    /// Place of its upper left pixel in the image, counted from the top.
    int left = 0;
    int top = 0;
};

/// Sorts the sets of dark pixels of a part of the image into specks, grains that touch the image's border,
/// and whole grains, which `keep` gets, holes filled. Counts them in `result`, whose width and height are the
/// image's.
void sortOut(const BinaryPart& part, int minPixels, ImageGrains& result,
             const std::function<void(Silhouette&&)>& keep);

/// "2 specks of fewer than 200 pixels, 1 grains touching the border": what was found instead of grains.
std::string droppedText(const ImageGrains& result, int minPixels);

} // namespace chesil
