#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace chesil
{

/// What stands around the sections of a checkpoint (checkpointFile.hpp): header and checksum.

/// Of header and checksum [bytes].
inline constexpr std::size_t checkpointFrameSize = 32 + 8 + 8 + 8;

/// For a file of this size, header and checksum included [bytes].
std::string checkpointHeader(std::size_t fileSize);

/// The last bytes of the file, from the pieces of all before them.
std::string checkpointChecksum(const std::vector<std::string_view>& pieces);

/// Reads the file once, in pieces, and hands the bytes between header and checksum on, unread. Throws
/// SetupError if it cannot be read, is no checkpoint of this version and byte order, has another size than it
/// tells, or another checksum; the last is known only after all bytes were handed on.
void readCheckedSections(const std::string& path,
                         const std::function<void(const char*, std::size_t)>& handOn);

} // namespace chesil
