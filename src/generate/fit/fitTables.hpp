#pragma once

#include "generate/fit/grainFit.hpp"

#include <string>
#include <vector>

namespace chesil
{

/// One row a grain: id,pixels,accuracySilhouette,accuracyHull,segments,milliseconds. Throws SetupError if the
/// file cannot be written.
void writeFitReport(const std::string& path, const std::vector<GrainFit>& fits);

/// Where each grain lay in the image: id,x,y,angle: the centroid from the image's lower left corner, y up, in
/// the unit of the grains, and GrainFit::angle. With the template of the same name it gives the outline in
/// the image. Throws SetupError if the file cannot be written.
void writePlacement(const std::string& path, const std::vector<GrainFit>& fits);

} // namespace chesil
