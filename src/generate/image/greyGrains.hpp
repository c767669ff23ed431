#pragma once

#include "generate/image/silhouetteReader.hpp"

namespace chesil
{

/// readGrains for a photo or drawing: grains are what is darker (or lighter) than a grey value.
ImageGrains readGreyGrains(const std::string& path, const ImageSettings& settings);

/// readGrains for a label image.
ImageGrains readLabelGrains(const std::string& path, const ImageSettings& settings);

/// From this share of the border on, ImageGrains::borderShare is suspicious.
constexpr double mostlyGrain = 0.5;

} // namespace chesil
