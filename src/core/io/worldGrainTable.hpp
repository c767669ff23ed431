#pragma once

#include "core/io/grainTable.hpp"
#include "core/world/world.hpp"

#include <string>
#include <vector>

namespace chesil
{

/// The grains of a world as they are now, in its order; in a periodic cell velocities are on top of its flow.
/// `start` is what the world was made from (WorldSettings::grains), for materials and driven grains. Shapes
/// in a size that is not their own are told by the original's name and that size, so that placeGrains makes
/// the same bits of them.
std::vector<GrainRow> grainRows(const World& world, const std::vector<GrainState>& start);

/// Throws ValueError for names of shapes or materials that a table cannot tell: two shapes of the same name,
/// or what requireTableName refuses.
void requireTableNames(const std::vector<NamedShape>& shapes, const std::vector<Material>& materials);

/// Grains from the rows of the file at `path`. Appends each size of a shape that is not there yet, once.
/// Materials that are not told become the first one. Throws SetupError that names file and line for an
/// unknown shape or material and for a size that no shape may have, ValueError as requireTableNames.
std::vector<GrainState> placeGrains(const std::string& path, const std::vector<GrainRow>& rows,
                                    std::vector<NamedShape>& shapes, const std::vector<Material>& materials);

} // namespace chesil
