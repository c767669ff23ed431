#include "core/base/setupError.hpp"

#include <filesystem>
#include <sstream>
#include <system_error>

namespace chesil
{

namespace
{

std::string belowHere(const std::string& file)
{
    const std::filesystem::path path(file);
    if (!path.is_absolute())
    {
        return file;
    }
    std::error_code error;
    const std::filesystem::path below = std::filesystem::relative(path, error);
    return error || below.empty() || *below.begin() == ".." || below == "." ? file : below.string();
}

} // namespace

SetupError::SetupError(std::string file, std::string entry, std::string found, std::string expected)
    : std::runtime_error("file " + belowHere(file) + ", entry " + entry + ": found " + found + "; expected " +
                         expected),
      file_(std::move(file)), entry_(std::move(entry)), found_(std::move(found)),
      expected_(std::move(expected))
{
}

std::string listOfNames(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
    {
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

std::string numberText(double value)
{
    std::ostringstream text;
    text << value;
    return text.str();
}

} // namespace chesil
