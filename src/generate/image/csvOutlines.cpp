#include "core/io/wordReader.hpp"
#include "generate/image/outlineFile.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace chesil
{

namespace
{

const std::string expectedHeader = "a header line with the columns id, x, y";

/// The fields of the line with these words.
std::vector<std::string> fieldsOf(const std::vector<std::string>& words)
{
    std::string line;
    for (const std::string& word : words)
    {
        line += (line.empty() || line.back() == ',' || word.front() == ',' ? "" : " ") + word;
    }
    std::vector<std::string> fields(1);
    for (const char letter : line)
    {
        if (letter == ',')
        {
            fields.emplace_back();
        }
        else
        {
            fields.back() += letter;
        }
    }
    return fields;
}

/// Where id, x and y stand in a row.
class Columns
{
public:
    explicit Columns(WordReader& reader)
    {
        const std::vector<std::string> header = fieldsOf(reader.next(expectedHeader));
        count_ = header.size();
        const std::array<std::string, 3> names{"id", "x", "y"};
        for (std::size_t i = 0; i < names.size(); ++i)
        {
            const auto place = std::find(header.begin(), header.end(), names[i]);
            if (place == header.end())
            {
                throw reader.fail("no column '" + names[i] + "'", expectedHeader);
            }
            places_[i] = static_cast<std::size_t>(place - header.begin());
        }
    }

    /// The fields id, x, y.
    std::array<std::string, 3> of(const WordReader& reader, const std::vector<std::string>& words) const
    {
        const std::vector<std::string> fields = fieldsOf(words);
        if (fields.size() != count_)
        {
            throw reader.fail(std::to_string(fields.size()) + " fields",
                              std::to_string(count_) + ", as in the header line");
        }
        return {fields[places_[0]], fields[places_[1]], fields[places_[2]]};
    }

private:
    std::size_t count_ = 0;
    std::array<std::size_t, 3> places_{};
};

/// The outline of one id while its rows are read.
struct OpenOutline
{
    std::string id;
    std::size_t line = 0;
    std::vector<Vector2> vertices;
};

void close(const WordReader& reader, OpenOutline& open, OutlineFile& file)
{
    try
    {
        file.outlines.push_back(checkedOutline(std::move(open.vertices)));
        file.names.push_back(open.id);
        file.places.push_back("line " + std::to_string(open.line));
    }
    catch (const ValueError& error)
    {
        throw reader.failAt(open.line, ValueError(error.found() + " (id " + open.id + ")", error.expected()));
    }
}

} // namespace

OutlineFile readCsvOutlines(const std::string& path)
{
    WordReader reader(path);
    const Columns columns(reader);
    OutlineFile file;
    OpenOutline open;
    std::set<std::string> ids;
    for (std::vector<std::string> words = reader.next("a row a vertex"); !words.empty();
         words = reader.nextOrNothing())
    {
        const auto [id, x, y] = columns.of(reader, words);
        if (open.vertices.empty() || id != open.id)
        {
            if (!open.vertices.empty())
            {
                close(reader, open, file);
            }
            if (!ids.insert(id).second)
            {
                throw reader.fail("id '" + id + "' again, after another one",
                                  "the rows of each outline together");
            }
            open = {id, reader.lineNumber(), {}};
        }
        open.vertices.emplace_back(reader.number(x), reader.number(y));
    }
    close(reader, open, file);
    return file;
}

} // namespace chesil
