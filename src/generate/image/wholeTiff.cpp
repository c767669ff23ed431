#include "generate/image/wholeTiff.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace chesil
{

namespace
{

constexpr int stripOffsets = 273;
constexpr int stripByteCounts = 279;
constexpr int tileOffsets = 324;
constexpr int tileByteCounts = 325;
constexpr int shortType = 3;

/// Numbers in a file, in its order of bytes; 0 beyond its end.
class ByteReader
{
public:
    explicit ByteReader(const std::string& path) : file_(path, std::ios::binary)
    {
        char order = 0;
        file_.get(order);
        bigEndian_ = order == 'M';
    }

    std::uint32_t number(std::uint64_t place, int bytes)
    {
        file_.clear();
        file_.seekg(static_cast<std::streamoff>(place));
        std::vector<char> found(static_cast<std::size_t>(bytes), 0);
        file_.read(found.data(), bytes);
        if (!bigEndian_)
        {
            std::reverse(found.begin(), found.end());
        }
        std::uint32_t value = 0;
        for (const char byte : found)
        {
            value = value << 8 | static_cast<unsigned char>(byte);
        }
        return value;
    }

    /// Of an entry of 12 bytes: tag, type, how many values, their place or the only one itself.
    std::vector<std::uint32_t> values(std::uint64_t entry, std::uint64_t fileSize)
    {
        const int bytes = number(entry + 2, 2) == shortType ? 2 : 4;
        const std::uint64_t count = number(entry + 4, 4);
        const std::uint64_t place =
            count * static_cast<unsigned>(bytes) <= 4 ? entry + 8 : number(entry + 8, 4);
        std::vector<std::uint32_t> found;
        for (std::uint64_t i = 0; i < count && place + i * static_cast<unsigned>(bytes) < fileSize; ++i)
        {
            found.push_back(number(place + i * static_cast<unsigned>(bytes), bytes));
        }
        return found;
    }

private:
    std::ifstream file_;
    bool bigEndian_ = false;
};

} // namespace

bool isWholeTiff(const std::string& path)
{
    ByteReader reader(path);
    const std::uint32_t order = reader.number(0, 2);
    if ((order != 0x4949 && order != 0x4d4d) || reader.number(2, 2) != 42)
    {
        return true;
    }
    std::error_code ignored;
    const std::uint64_t size = std::filesystem::file_size(path, ignored);
    const std::uint64_t directory = reader.number(4, 4);
    std::vector<std::uint32_t> offsets;
    std::vector<std::uint32_t> counts;
    for (std::uint32_t i = 0; i < reader.number(directory, 2); ++i)
    {
        const std::uint64_t entry = directory + 2 + 12 * std::uint64_t{i};
        const std::uint32_t tag = reader.number(entry, 2);
        if (tag == stripOffsets || tag == tileOffsets)
        {
            offsets = reader.values(entry, size);
        }
        else if (tag == stripByteCounts || tag == tileByteCounts)
        {
            counts = reader.values(entry, size);
        }
    }
    for (std::size_t i = 0; i < std::min(offsets.size(), counts.size()); ++i)
    {
        if (std::uint64_t{offsets[i]} + counts[i] > size)
        {
            return false;
        }
    }
    return true;
}

} // namespace chesil
