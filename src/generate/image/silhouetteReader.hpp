#pragma once

#include "generate/image/silhouette.hpp"

#include <optional>
#include <string>
#include <vector>

namespace chesil
{

/// How grains are told from the ground.
struct ImageSettings
{
    /// Pixels with a grey value (0 black to 255 white) up to this one are grain; without it Otsu's choice.
    std::optional<int> threshold;
    /// Grains of fewer pixels are specks and dropped.
    int minPixels = 200;
};

/// What an image holds.
struct ImageGrains
{
    /// Whole grains, in the order in which reading the image from its top left corner meets them.
    std::vector<Silhouette> grains;
    int specksDropped = 0;
    /// Grains of minPixels and more that touch the image's border, hence may be cut off.
    int borderDropped = 0;
    int threshold = 0;
    int width = 0;
    int height = 0;
};

/// Reads dark grains on a light ground from an image in any format Leptonica knows (PNG, JPEG, TIFF, ...);
/// colour becomes grey, what is transparent becomes white. A grain is a set of dark pixels joined by
/// their edges (4 neighbours), so that grains that touch at a pixel's corner only stay apart; holes in it
/// stay holes.
///
/// Throws SetupError if the file cannot be read, is no image or is cut short, if a setting is out of range,
/// or if no whole grain is found.
ImageGrains readGrains(const std::string& path, const ImageSettings& settings = {});

} // namespace chesil
