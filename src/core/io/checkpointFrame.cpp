#include "core/io/checkpointFrame.hpp"

#include "core/base/setupError.hpp"
#include "core/io/crc64.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace chesil
{

namespace
{

const std::string title = "chesil checkpoint ";
const std::string version = "3";
constexpr std::uint64_t byteOrderMark = 0x0102030405060708;

constexpr std::size_t titleSpace = 32;
constexpr std::size_t wordSize = sizeof(std::uint64_t);
constexpr std::size_t headerSize = titleSpace + 2 * wordSize;
static_assert(checkpointFrameSize == headerSize + wordSize, "header and checksum");

std::string bytesOf(std::uint64_t word)
{
    return std::string(reinterpret_cast<const char*>(&word), wordSize);
}

std::uint64_t wordAt(const char* bytes)
{
    std::uint64_t word = 0;
    std::memcpy(&word, bytes, wordSize);
    return word;
}

std::string hexText(std::uint64_t word)
{
    std::ostringstream text;
    text << "0x" << std::hex << word;
    return text.str();
}

/// Opens, reads and fails with the system's reason.
class PieceReader
{
public:
    explicit PieceReader(const std::string& path) : path_(path)
    {
        errno = 0;
        std::error_code error;
        size_ = std::filesystem::file_size(path, error);
        file_.open(path, std::ios::binary);
        if (error || !file_)
        {
            throw SetupError(path, "file", error ? error.message() : std::strerror(errno),
                             "a checkpoint that can be read");
        }
    }

    std::size_t size() const { return size_; }

    void read(char* bytes, std::size_t count)
    {
        errno = 0;
        if (!file_.read(bytes, static_cast<std::streamsize>(count)))
        {
            throw SetupError(path_, "file",
                             errno != 0 ? std::strerror(errno) : "that it became shorter meanwhile",
                             "a checkpoint that can be read");
        }
    }

private:
    std::string path_;
    std::ifstream file_;
    std::size_t size_ = 0;
};

void requireHeader(const std::string& path, const std::string& header, std::size_t fileSize)
{
    if (header.compare(0, title.size(), title) != 0)
    {
        throw SetupError(path, "first line", "no checkpoint", "'" + title + version + "'");
    }
    const std::size_t end = std::min(header.find('\n'), titleSpace);
    const std::string found = header.substr(title.size(), end - title.size());
    if (found != version)
    {
        throw SetupError(path, "version", "'" + found + "'",
                         "'" + version + "', the one this program writes");
    }
    const std::uint64_t mark = wordAt(header.data() + titleSpace);
    if (mark != byteOrderMark)
    {
        throw SetupError(path, "byte order mark", hexText(mark),
                         hexText(byteOrderMark) +
                             ": a checkpoint goes on on the kind of machine that wrote it");
    }
    const std::uint64_t size = wordAt(header.data() + titleSpace + wordSize);
    if (size != fileSize)
    {
        throw SetupError(path, "size", std::to_string(fileSize) + " bytes (cut short?)",
                         std::to_string(size) + " bytes, as its header tells");
    }
}

} // namespace

std::string checkpointHeader(std::size_t fileSize)
{
    std::string header = title + version + '\n';
    header.resize(titleSpace, '\0');
    return header + bytesOf(byteOrderMark) + bytesOf(fileSize);
}

std::string checkpointChecksum(const std::vector<std::string_view>& pieces)
{
    Crc64 sum;
    for (const std::string_view piece : pieces)
    {
        sum.add(piece.data(), piece.size());
    }
    return bytesOf(sum.value());
}

void readCheckedSections(const std::string& path, const std::function<void(const char*, std::size_t)>& handOn)
{
    PieceReader file(path);
    if (file.size() < checkpointFrameSize)
    {
        throw SetupError(path, "size", std::to_string(file.size()) + " bytes (cut short?)",
                         "a checkpoint, " + std::to_string(checkpointFrameSize) + " bytes at least");
    }
    std::string header(headerSize, '\0');
    file.read(header.data(), headerSize);
    requireHeader(path, header, file.size());

    Crc64 sum;
    sum.add(header.data(), headerSize);
    std::vector<char> piece(std::size_t{1} << 16);
    for (std::size_t left = file.size() - checkpointFrameSize; left > 0;)
    {
        const std::size_t count = std::min(left, piece.size());
        file.read(piece.data(), count);
        sum.add(piece.data(), count);
        handOn(piece.data(), count);
        left -= count;
    }
    file.read(piece.data(), wordSize);
    const std::uint64_t expected = wordAt(piece.data());
    if (sum.value() != expected)
    {
        throw SetupError(path, "checksum", hexText(sum.value()) + " (bytes changed)",
                         hexText(expected) + ", as its end tells");
    }
}

} // namespace chesil
