#pragma once

#include "core/io/checkpointFile.hpp"
#include "core/world/worldState.hpp"

namespace chesil
{

/// Adds the sections of a world's state: arrays of numbers under their names, vectors as x and y in turn.
void addState(CheckpointWriter& writer, const WorldState& state);

/// Takes them out. Throws SetupError for a section that is missing or of the wrong length.
WorldState takeState(CheckpointReader& reader);

} // namespace chesil
