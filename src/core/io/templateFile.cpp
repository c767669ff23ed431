#include "core/io/templateFile.hpp"

#include "core/base/setupError.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

namespace chesil
{

namespace
{

const std::vector<std::string> knownUnits{"m", "pixel"};
const std::vector<std::string> knownTypes{Circle::typeName, Ellipse::typeName, ConvexPolygon::typeName,
                                          PolyBezier::typeName};

std::string systemMessage() { return errno != 0 ? std::strerror(errno) : "an input/output error"; }

/// The words of a text file, line by line: comments taken off, empty lines passed over.
class LineReader
{
public:
    explicit LineReader(const std::string& path) : path_(path)
    {
        errno = 0;
        file_.open(path);
        // A folder opens well and fails at the first read.
        if (!file_ || (file_.peek() == std::ifstream::traits_type::eof() && file_.bad()))
        {
            throw SetupError(path, "file", systemMessage(), "a template file that can be read");
        }
    }

    /// The words of the next line that has any. Throws SetupError at the end of the file.
    std::vector<std::string> next(const std::string& expected)
    {
        std::vector<std::string> words = nextOrNothing();
        if (words.empty())
        {
            throw fail("the end of the file (cut short?)", expected);
        }
        return words;
    }

    /// As next, but gives no words at the end of the file.
    std::vector<std::string> nextOrNothing()
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

    std::size_t lineNumber() const { return lineNumber_; }

    SetupError fail(const std::string& found, const std::string& expected) const
    {
        return failAt(lineNumber_, ValueError(found, expected));
    }

    SetupError failAt(std::size_t line, const ValueError& error) const
    {
        return error.at(path_, "line " + std::to_string(line));
    }

private:
    std::string path_;
    std::ifstream file_;
    std::size_t lineNumber_ = 0;
};

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
    {
        text += (text.empty() ? "'" : " ") + word;
    }
    return text + "'";
}

double readNumber(const LineReader& reader, const std::string& word)
{
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (*end != '\0' || !std::isfinite(number))
    {
        throw reader.fail("'" + word + "'", "a finite number");
    }
    return number;
}

std::size_t readCount(const LineReader& reader, const std::string& word)
{
    constexpr double most = 1e9;
    const double number = readNumber(reader, word);
    if (number < 0 || number > most || number != std::floor(number))
    {
        throw reader.fail("'" + word + "'", "a whole number from 0 to 1e9");
    }
    return static_cast<std::size_t>(number);
}

/// The value of a line "keyword value".
std::string readEntry(LineReader& reader, const std::string& keyword)
{
    const std::string expected = "'" + keyword + " <value>'";
    const std::vector<std::string> words = reader.next(expected);
    if (words.size() != 2 || words[0] != keyword)
    {
        throw reader.fail(joined(words), expected);
    }
    return words[1];
}

/// Rows of `width` numbers as points, two numbers each.
std::vector<Vector2> readPoints(LineReader& reader, std::size_t rows, std::size_t width)
{
    const std::string expected = std::to_string(width) + " numbers";
    std::vector<Vector2> points;
    for (std::size_t row = 0; row < rows; ++row)
    {
        const std::vector<std::string> words = reader.next(expected);
        if (words.size() != width)
        {
            throw reader.fail(joined(words), expected);
        }
        for (std::size_t i = 0; i < width; i += 2)
        {
            points.emplace_back(readNumber(reader, words[i]), readNumber(reader, words[i + 1]));
        }
    }
    return points;
}

PolyBezier readPolyBezier(LineReader& reader, std::size_t count)
{
    const std::vector<Vector2> points = readPoints(reader, count, 6);
    std::vector<CubicBezier> segments;
    for (std::size_t i = 0; i < points.size(); i += 3)
    {
        segments.emplace_back(
            std::array<Vector2, 4>{points[i], points[i + 1], points[i + 2], points[(i + 3) % points.size()]});
    }
    return PolyBezier(segments);
}

/// The shape of the line "grain <name> <type> <numbers>" and of the lines that belong to it.
Shape readShape(LineReader& reader, const std::vector<std::string>& words)
{
    const auto requireNumbers = [&](std::size_t count, const char* what)
    {
        if (words.size() != 3 + count)
        {
            throw reader.fail(joined(words), "'grain <name> " + words[2] + " " + what + "'");
        }
    };
    const std::string& type = words[2];
    if (type == Circle::typeName)
    {
        requireNumbers(1, "<radius>");
        return Circle(readNumber(reader, words[3]));
    }
    if (type == Ellipse::typeName)
    {
        requireNumbers(2, "<half-axis> <half-axis>");
        return Ellipse(readNumber(reader, words[3]), readNumber(reader, words[4]));
    }
    if (type == ConvexPolygon::typeName)
    {
        requireNumbers(1, "<number of vertices>");
        return ConvexPolygon(readPoints(reader, readCount(reader, words[3]), 2));
    }
    if (type == PolyBezier::typeName)
    {
        requireNumbers(1, "<number of segments>");
        return readPolyBezier(reader, readCount(reader, words[3]));
    }
    throw reader.fail("the type '" + type + "'", "one of " + listOfNames(knownTypes));
}

NamedShape readGrain(LineReader& reader)
{
    const std::string expected = "'grain <name> <type> <numbers>'";
    const std::vector<std::string> words = reader.next(expected);
    if (words.size() < 3 || words[0] != "grain")
    {
        throw reader.fail(joined(words), expected);
    }
    const std::size_t line = reader.lineNumber();
    try
    {
        return {words[1], readShape(reader, words)};
    }
    catch (const ValueError& error)
    {
        throw reader.failAt(line,
                            ValueError("in grain '" + words[1] + "' " + error.found(), error.expected()));
    }
}

std::string numberTextExact(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

std::string pointText(const Vector2& point)
{
    return numberTextExact(point.x()) + " " + numberTextExact(point.y());
}

/// What follows "grain <name> <type> ".
struct ShapeWriter
{
    std::ostream& file;

    void operator()(const Circle& circle) const { file << numberTextExact(circle.radius()) << '\n'; }

    void operator()(const Ellipse& ellipse) const
    {
        file << numberTextExact(ellipse.a()) << ' ' << numberTextExact(ellipse.b()) << '\n';
    }

    void operator()(const ConvexPolygon& polygon) const
    {
        file << polygon.vertices().size() << '\n';
        for (const Vector2& vertex : polygon.vertices())
        {
            file << pointText(vertex) << '\n';
        }
    }

    void operator()(const PolyBezier& grain) const
    {
        file << grain.segments().size() << '\n';
        for (const CubicBezier& segment : grain.segments())
        {
            const auto& points = segment.controlPoints();
            file << pointText(points[0]) << ' ' << pointText(points[1]) << ' ' << pointText(points[2])
                 << '\n';
        }
    }
};

std::string typeNameOf(const Shape& shape)
{
    return std::visit([](const auto& s) -> std::string { return s.typeName; }, shape);
}

void requireWritable(const std::string& path, const TemplateFile& templates)
{
    if (std::find(knownUnits.begin(), knownUnits.end(), templates.unit) == knownUnits.end())
    {
        throw SetupError(path, "unit", "'" + templates.unit + "'", "one of " + listOfNames(knownUnits));
    }
    std::set<std::string> names;
    for (const NamedShape& grain : templates.grains)
    {
        if (grain.name.empty() || grain.name.find_first_of("# \t\r\n\v\f") != std::string::npos)
        {
            throw SetupError(path, "grain name", "'" + grain.name + "'", "one word without #");
        }
        if (!names.insert(grain.name).second)
        {
            throw SetupError(path, "grain name", "'" + grain.name + "' twice",
                             "a name of its own for each grain");
        }
    }
}

} // namespace

TemplateFile readTemplates(const std::string& path)
{
    LineReader reader(path);
    if (reader.next("'chesilTemplates 1'") != std::vector<std::string>{"chesilTemplates", "1"})
    {
        throw reader.fail("no template file of version 1", "'chesilTemplates 1' as the first line");
    }
    TemplateFile templates;
    templates.unit = readEntry(reader, "unit");
    if (std::find(knownUnits.begin(), knownUnits.end(), templates.unit) == knownUnits.end())
    {
        throw reader.fail("the unit '" + templates.unit + "'", "one of " + listOfNames(knownUnits));
    }
    const std::size_t count = readCount(reader, readEntry(reader, "count"));

    std::set<std::string> names;
    for (std::size_t i = 0; i < count; ++i)
    {
        templates.grains.push_back(readGrain(reader));
        const std::string& name = templates.grains.back().name;
        if (!names.insert(name).second)
        {
            throw reader.fail("a second grain '" + name + "'", "a name of its own for each grain");
        }
    }
    const std::vector<std::string> last = reader.next("'end'");
    if (last != std::vector<std::string>{"end"})
    {
        throw reader.fail(joined(last), "'end' after " + std::to_string(count) + " grains");
    }
    const std::vector<std::string> surplus = reader.nextOrNothing();
    if (!surplus.empty())
    {
        throw reader.fail(joined(surplus), "nothing after 'end'");
    }
    return templates;
}

void writeTemplates(const std::string& path, const TemplateFile& templates)
{
    requireWritable(path, templates);
    const std::string aside = path + ".part";
    errno = 0;
    std::ofstream file(aside);
    file << "chesilTemplates 1\nunit " << templates.unit << "\ncount " << templates.grains.size() << '\n';
    for (const NamedShape& grain : templates.grains)
    {
        file << "grain " << grain.name << ' ' << typeNameOf(grain.shape) << ' ';
        std::visit(ShapeWriter{file}, grain.shape);
    }
    file << "end\n";
    file.close();
    if (!file || std::rename(aside.c_str(), path.c_str()) != 0)
    {
        const std::string message = systemMessage();
        std::remove(aside.c_str());
        throw SetupError(path, "output file", message, "a path that can be written");
    }
}

} // namespace chesil
