#pragma once

#include "core/io/templateFile.hpp"
#include "generate/descriptors/shapeDescriptors.hpp"
#include "generate/image/silhouetteReader.hpp"

#include <string>
#include <vector>

namespace chesil
{

struct DescribedGrain
{
    std::string name;
    /// "sub-pixel", "pixel" or "template".
    std::string source;
    /// In the image's frame, or the template's.
    ClosedOutline outline;
    ShapeDescriptors shape;
};

/// `scale`: length of an image's pixel, or of the unit of a file of outlines.
std::vector<DescribedGrain> describeGrains(const ImageGrains& image, double scale);

std::vector<DescribedGrain> describeGrains(const TemplateFile& templates);

/// Tables (CSV), written aside and renamed. Lengths in `unit`, which the first line names; angles in degrees. Throw SetupError if
/// the file cannot be written.
///
/// A row a grain: all of ShapeDescriptors but the spectrum, the circles with their centres.
void writeDescriptors(const std::string& path, const std::vector<DescribedGrain>& grains, const std::string& unit);

/// A row a grain: D_0 to D_64; empty for one that is not star-shaped.
void writeSpectra(const std::string& path, const std::vector<DescribedGrain>& grains);

/// A row a point: id, x, y, as chesilFit reads outlines.
void writeOutlines(const std::string& path, const std::vector<DescribedGrain>& grains);

} // namespace chesil
