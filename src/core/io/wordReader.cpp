#include "core/io/wordReader.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace chesil
{

WordReader::WordReader(const std::string& path) : path_(path)
{
    errno = 0;
    file_.open(path);
    // A folder opens well and fails at the first read.
    if (!file_ || (file_.peek() == std::ifstream::traits_type::eof() && errno != 0))
    {
        throw SetupError(path, "file", errno != 0 ? std::strerror(errno) : "an unreadable file",
                         "a file that can be read");
    }
    file_.clear();
}

std::vector<std::string> WordReader::next(const std::string& expected)
{
    std::vector<std::string> words = nextOrNothing();
    if (words.empty())
    {
        throw fail("the end of the file (cut short?)", expected);
    }
    return words;
}

std::vector<std::string> WordReader::nextOrNothing()
{
    std::string line;
    while (std::getline(file_, line))
    {
        ++lineNumber_;
        std::istringstream content(line.substr(0, line.find('#')));
        std::vector<std::string> words;
        for (std::string word; content >> word;)
        {
            words.push_back(word);
        }
        if (!words.empty())
        {
            return words;
        }
    }
    ++lineNumber_;
    return {};
}

double WordReader::number(const std::string& word) const
{
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(value))
    {
        throw fail("'" + word + "'", "a finite number");
    }
    return value;
}

SetupError WordReader::fail(const std::string& found, const std::string& expected) const
{
    return failAt(lineNumber_, ValueError(found, expected));
}

SetupError WordReader::failAt(std::size_t line, const ValueError& error) const
{
    return error.at(path_, "line " + std::to_string(line));
}

std::string inQuotes(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
    {
        text += (text.empty() ? "'" : " ") + word;
    }
    return text + "'";
}

} // namespace chesil
