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
    /// Pixels with a grey value (0 black to 255 white, or to 65535 for 16 bits) up to this one are dark;
    /// without it Otsu's choice.
    std::optional<int> threshold;
    /// Grains of fewer pixels are specks and dropped.
    int minPixels = 200;
    /// Light grains on a dark ground.
    bool lightGrains = false;
    /// The image has a value of its own for each grain.
    bool labels = false;
    /// The ground's value in a label image; without it 0.
    std::optional<int> ground;
    /// Grains that seem to touch are cut apart (partsAtNecks).
    bool split = false;
};

enum class ImageKind
{
    grey,
    labels,
    outlines
};

/// A silhouette that seems to be several grains that touch.
struct TouchingGrains
{
    /// Index of the silhouette; if it was cut, of its first part.
    std::size_t grain = 0;
    int parts = 0;
};

/// What an image holds.
struct ImageGrains
{
    ImageKind kind = ImageKind::grey;
    /// Whole grains, holes filled, in the order in which reading the image from its top left corner meets
    /// them, labels from the least on, outlines in the file's order.
    std::vector<Silhouette> grains;
    /// Of the grains, if the file has names; else grainName.
    std::vector<std::string> names;
    int specksDropped = 0;
    /// Grains of minPixels and more that touch the image's border, hence may be cut off.
    int borderDropped = 0;
    int holesFilled = 0;
    /// Of a label image: how many labels there are, and how many of them are in more than one piece, each of
    /// which is sorted out by itself.
    int labels = 0;
    int labelsInPieces = 0;
    /// Grey images only; cut if settings.split says so.
    std::vector<TouchingGrains> touching;
    /// Of a grey image; white's value, 255 or 65535.
    int threshold = 0;
    int white = 255;
    /// Largest share of the border that one set of grain pixels has; a grey image with much of it may show
    /// light grains on a dark ground, or the other way round.
    double borderShare = 0;
    /// [pixel], 0 for outlines.
    int width = 0;
    int height = 0;
    /// Of a silhouette's pixel: 1 [image's pixel], for outlines in the file's unit.
    double pixelSize = 1;

    /// The grain's name in template files, tables and messages.
    std::string name(std::size_t index) const;
};

/// Reads grains, by the path's ending:
/// - .csv, .geojson, .json: outlines (outlineFile.hpp). No setting applies;
/// - else an image in any format Leptonica knows (PNG, JPEG, TIFF, ...); colour becomes grey, what is
/// transparent
///   becomes ground. A grain is a set of pixels (of one label, if settings.labels) joined by their edges (4
///   neighbours), so that grains that touch at a pixel's corner only stay apart. Holes in it are filled. A
///   grey image's grains have an outline() if subPixelOutline finds one.
///
/// Throws SetupError if the file cannot be read, is no image, is cut short or too large, if a setting is out
/// of range or does not go with the kind of file, or if no whole grain is found.
ImageGrains readGrains(const std::string& path, const ImageSettings& settings = {});

/// The name of grain `index` (from 0) of a file that has no names: "grain1", "grain2", ...
std::string grainName(std::size_t index);

} // namespace chesil
