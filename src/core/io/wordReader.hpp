#pragma once

#include "core/base/setupError.hpp"

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace chesil
{

/// Reads a text file line by line as words; what follows # and empty lines are passed over. Its errors name
/// the file and the line.
class WordReader
{
public:
    /// Throws SetupError if the file cannot be read.
    explicit WordReader(const std::string& path);

    /// The words of the next line that has any; throws SetupError at the end of the file. `expected` is for
    /// the message.
    std::vector<std::string> next(const std::string& expected);

    /// As next, but gives no words at the end of the file.
    std::vector<std::string> nextOrNothing();

    /// A word of the last line as a number; throws SetupError unless all of it is one, and finite.
    double number(const std::string& word) const;

    /// Of the last line, from 1.
    std::size_t lineNumber() const { return lineNumber_; }

    /// An error at the last line, or at an earlier one.
    SetupError fail(const std::string& found, const std::string& expected) const;
    SetupError failAt(std::size_t line, const ValueError& error) const;

private:
    std::string path_;
    std::ifstream file_;
    std::size_t lineNumber_ = 0;
};

/// 'one two three', for messages.
std::string inQuotes(const std::vector<std::string>& words);

} // namespace chesil
