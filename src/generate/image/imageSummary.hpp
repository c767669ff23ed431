#pragma once

#include "generate/image/silhouetteReader.hpp"

#include <string>

namespace chesil
{

/// What was read, in a line: "Image photo.png: 640 x 480 pixels, grey values up to 120 taken as grain".
std::string imageTitle(const std::string& path, const ImageGrains& image, const ImageSettings& settings);

/// What was dropped, filled and cut, and what the user should look at: grains that seem to touch, by name;
/// grains of a convexity below farFromConvex, by name with their convexity; a border that is mostly grain. A
/// line each.
std::string imageFindings(const ImageGrains& image, const ImageSettings& settings);

constexpr double farFromConvex = 0.9;

} // namespace chesil
