#include "core/io/fileAside.hpp"

#include "core/base/setupError.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace chesil
{

void writeAside(const std::string& path, const std::function<void(std::ostream&)>& content)
{
    const std::string aside = path + ".part";
    const auto fail = [&](const std::string& what)
    {
        const std::string reason = std::strerror(errno);
        std::error_code ignored;
        std::filesystem::remove(aside, ignored);
        throw SetupError(path, "(whole file)", what + ": " + reason, "a folder that can be written to, with space left");
    };
    {
        std::ofstream file(aside);
        if (!file)
        {
            fail("no way to open it for writing");
        }
        try
        {
            content(file);
        }
        catch (...)
        {
            std::error_code ignored;
            std::filesystem::remove(aside, ignored);
            throw;
        }
        file.close();
        if (!file)
        {
            fail("an error while writing");
        }
    }
    if (std::rename(aside.c_str(), path.c_str()) != 0)
    {
        fail("an error while renaming");
    }
}

} // namespace chesil
