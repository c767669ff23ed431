#pragma once

#include "core/io/checkpointFile.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace chesil
{

/// The checkpoint a run can go on from.
struct NewestCheckpoint
{
    /// Nothing if the folder has no whole checkpoint.
    std::optional<std::string> path;
    /// Why newer ones were passed over, newest first.
    std::vector<std::string> broken;
};

/// The checkpoints of one run, `checkpoint_<step>` each, the step with zeros in front: the last two that are
/// whole. One run at a time may write there. The folder must exist; what else lies in it is left alone.
class CheckpointFolder
{
public:
    explicit CheckpointFolder(std::string folder) : folder_(std::move(folder)) {}

    /// Adds the sections "step" (uint64) and "time" (double, [s]; ValueError if they are there), writes the
    /// file, and only then removes those older than the newest two that are whole, without a look into them.
    /// Broken ones among the newest stay until two whole ones have passed them. What killed runs left half
    /// written goes first, to make room. Throws SetupError if that fails; the newest two that were whole
    /// before are then still there.
    ///
    /// Also throws SetupError, and writes nothing, if there is a whole checkpoint of a later step: it belongs
    /// to another run, or this one did not start from its newest.
    void write(CheckpointWriter writer, std::uint64_t step, double time) const;

    /// Reads from the newest on until the checksum of one holds. Throws SetupError if the folder cannot be
    /// read.
    NewestCheckpoint newestValid() const;

private:
    std::string folder_;
};

} // namespace chesil
