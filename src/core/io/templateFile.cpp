#include "core/io/templateFile.hpp"

#include "core/base/setupError.hpp"
#include "core/io/fileAside.hpp"
#include "core/io/wordReader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

namespace chesil
{

namespace
{

const std::vector<std::string> knownUnits{"m", "pixel"};
const std::vector<std::string> knownTypes{Circle::typeName, Ellipse::typeName, ConvexPolygon::typeName,
                                          PolyBezier::typeName};

std::size_t readCount(const WordReader& reader, const std::string& word)
{
    constexpr double most = 1e9;
    const double number = reader.number(word);
    if (number < 0 || number > most || number != std::floor(number))
    {
        throw reader.fail("'" + word + "'", "a whole number from 0 to 1e9");
    }
    return static_cast<std::size_t>(number);
}

/// The value of a line "keyword value".
std::string readEntry(WordReader& reader, const std::string& keyword)
{
    const std::string expected = "'" + keyword + " <value>'";
    const std::vector<std::string> words = reader.next(expected);
    if (words.size() != 2 || words[0] != keyword)
    {
        throw reader.fail(inQuotes(words), expected);
    }
    return words[1];
}

/// Rows of `width` numbers as points, two numbers each.
std::vector<Vector2> readPoints(WordReader& reader, std::size_t rows, std::size_t width)
{
    const std::string expected = std::to_string(width) + " numbers";
    std::vector<Vector2> points;
    for (std::size_t row = 0; row < rows; ++row)
    {
        const std::vector<std::string> words = reader.next(expected);
        if (words.size() != width)
        {
            throw reader.fail(inQuotes(words), expected);
        }
        for (std::size_t i = 0; i < width; i += 2)
        {
            points.emplace_back(reader.number(words[i]), reader.number(words[i + 1]));
        }
    }
    return points;
}

PolyBezier readPolyBezier(WordReader& reader, std::size_t count)
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
Shape readShape(WordReader& reader, const std::vector<std::string>& words)
{
    const auto requireNumbers = [&](std::size_t count, const char* what)
    {
        if (words.size() != 3 + count)
        {
            throw reader.fail(inQuotes(words), "'grain <name> " + words[2] + " " + what + "'");
        }
    };
    const std::string& type = words[2];
    if (type == Circle::typeName)
    {
        requireNumbers(1, "<radius>");
        return Circle(reader.number(words[3]));
    }
    if (type == Ellipse::typeName)
    {
        requireNumbers(2, "<half-axis> <half-axis>");
        return Ellipse(reader.number(words[3]), reader.number(words[4]));
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

NamedShape readGrain(WordReader& reader)
{
    const std::string expected = "'grain <name> <type> <numbers>'";
    const std::vector<std::string> words = reader.next(expected);
    if (words.size() < 3 || words[0] != "grain")
    {
        throw reader.fail(inQuotes(words), expected);
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
    WordReader reader(path);
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
        throw reader.fail(inQuotes(last), "'end' after " + std::to_string(count) + " grains");
    }
    const std::vector<std::string> surplus = reader.nextOrNothing();
    if (!surplus.empty())
    {
        throw reader.fail(inQuotes(surplus), "nothing after 'end'");
    }
    return templates;
}

void writeTemplates(const std::string& path, const TemplateFile& templates)
{
    requireWritable(path, templates);
    writeAside(path,
               [&](std::ostream& file)
               {
                   file << "chesilTemplates 1\nunit " << templates.unit << "\ncount "
                        << templates.grains.size() << '\n';
                   for (const NamedShape& grain : templates.grains)
                   {
                       file << "grain " << grain.name << ' ' << typeNameOf(grain.shape) << ' ';
                       std::visit(ShapeWriter{file}, grain.shape);
                   }
                   file << "end\n";
               });
}

} // namespace chesil
