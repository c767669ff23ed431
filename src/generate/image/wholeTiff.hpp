#pragma once

#include <string>

namespace chesil
{

/// False if the first picture of a TIFF file (TIFF 6.0) has strips or tiles that reach beyond the end of the
/// file. libtiff, and with it Leptonica, fills what is missing of colour images in without a word. True for
/// what is no such file.
bool isWholeTiff(const std::string& path);

} // namespace chesil
