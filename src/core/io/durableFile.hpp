#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace chesil
{

/// What writeDurably appends to the name of a file that is not yet whole.
inline constexpr const char* partSuffix = ".part";

/// Writes the pieces, one after the other, to a file beside `path`, waits until the disk has them (fsync),
/// renames it to `path` and waits for the folder, too: after a crash, even of the machine, `path` is the old
/// file or the whole new one; after the return it is the new one. Throws SetupError with the system's reason
/// if that fails (no folder, no right, disk full); the old file then stays, and no part of the new one unless
/// its removal fails, too.
///
/// writeAside does not wait for the disk: it is for results, this is for what a run cannot do without.
void writeDurably(const std::string& path, const std::vector<std::string_view>& pieces);

} // namespace chesil
