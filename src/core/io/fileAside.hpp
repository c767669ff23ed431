#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace chesil
{

/// Writes a text file under a temporary name beside it, then renames it: whoever looks finds the old file or the
/// whole new one. Throws SetupError if that fails (no folder, no right, disk full), or what `content` throws; the old
/// file stays.
void writeAside(const std::string& path, const std::function<void(std::ostream&)>& content);

} // namespace chesil
