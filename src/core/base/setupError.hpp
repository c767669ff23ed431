#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace chesil
{

/// What is wrong with the user's input, told so that it can be mended without reading code: the file,
/// the entry, the value found, what would be right. Thrown during set-up only, never by the step loop.
class SetupError : public std::runtime_error
{
public:
    /// The message shows the file as the user at work in this folder would write it: relative if it lies below.
    SetupError(std::string file, std::string entry, std::string found, std::string expected);

    /// As given.
    const std::string& file() const { return file_; }
    const std::string& entry() const { return entry_; }
    const std::string& found() const { return found_; }
    const std::string& expected() const { return expected_; }

private:
    std::string file_;
    std::string entry_;
    std::string found_;
    std::string expected_;
};

/// A value that is not fit for its purpose, thrown by code that does not know which file it came from
/// (a shape's constructor, say). Whoever read the file turns it into a SetupError.
class ValueError : public std::runtime_error
{
public:
    ValueError(std::string found, std::string expected)
    : std::runtime_error("found " + found + "; expected " + expected), found_(std::move(found)), expected_(std::move(expected))
    {
    }

    const std::string& found() const { return found_; }
    const std::string& expected() const { return expected_; }

    SetupError at(const std::string& file, const std::string& entry) const
    {
        return SetupError(file, entry, found_, expected_);
    }

private:
    std::string found_;
    std::string expected_;
};

/// "a, b, c": the known names, for the error message of a misspelt one.
std::string listOfNames(const std::vector<std::string>& names);

/// A number as a user would write it, for messages.
std::string numberText(double value);

} // namespace chesil
