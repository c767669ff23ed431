#include "core/io/durableFile.hpp"

#include "core/base/setupError.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace chesil
{

namespace
{

/// Throws SetupError with the reason in errno.
[[noreturn]] void failFor(const std::string& path, const std::string& what)
{
    throw SetupError(path, "(whole file)", what + ": " + std::strerror(errno),
                     "a folder that can be written to, with space left");
}

/// An open file or folder, closed at the end of its scope.
class Descriptor
{
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (number_ >= 0)
        {
            ::close(number_);
        }
    }

    int number() const { return number_; }

    /// False with errno on errors that the system kept until now, as network drives do.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

bool writeAll(int file, std::string_view bytes)
{
    while (!bytes.empty())
    {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
        {
            return false;
        }
        bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
    return true;
}

void writeAndSync(const std::string& part, const std::string& path,
                  const std::vector<std::string_view>& pieces)
{
    constexpr mode_t readAndWriteForAllThatUmaskAllows = 0666;
    Descriptor file(
        ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, readAndWriteForAllThatUmaskAllows));
    if (file.number() < 0)
    {
        failFor(path, "no way to open it for writing");
    }
    for (const std::string_view piece : pieces)
    {
        if (!writeAll(file.number(), piece))
        {
            failFor(path, "an error while writing");
        }
    }
    if (::fsync(file.number()) != 0 || !file.close())
    {
        failFor(path, "an error while waiting for the disk");
    }
}

/// Makes the new name last. Some network drives cannot do that for folders and say EINVAL; they keep names
/// themselves.
void syncFolder(const std::string& path)
{
    const std::filesystem::path parent = std::filesystem::path(path).parent_path();
    const Descriptor folder(
        ::open(parent.empty() ? "." : parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.number() < 0 || (::fsync(folder.number()) != 0 && errno != EINVAL))
    {
        failFor(path, "an error while waiting for the disk to take the file's name");
    }
}

} // namespace

void writeDurably(const std::string& path, const std::vector<std::string_view>& pieces)
{
    const std::string part = path + partSuffix;
    try
    {
        writeAndSync(part, path, pieces);
        if (std::rename(part.c_str(), path.c_str()) != 0)
        {
            failFor(path, "an error while renaming");
        }
    }
    catch (...)
    {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw;
    }
    syncFolder(path);
}

} // namespace chesil
