#pragma once

#include "generate/image/silhouetteReader.hpp"

#include <string>

namespace chesil
{

/// Grains of a CSV or GeoJSON file (outlineFile.hpp), each drawn on a grid of pixels on which the median one
/// is outlinePixelsAcross wide or high, with its exact outline(). Throws SetupError as the readers do, and
/// for an outline mostTimesTheMedian as large as the median one, two outlines of the same name (says both
/// places), and a name with a character that template files and tables cannot hold: blanks and # , ".
ImageGrains readOutlineGrains(const std::string& path);

constexpr int outlinePixelsAcross = 400;
constexpr int mostTimesTheMedian = 25;

/// By the ending of the path: .csv, .geojson or .json, in any case.
bool isOutlinePath(const std::string& path);

} // namespace chesil
