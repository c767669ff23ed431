#include "core/io/grainTable.hpp"

#include "core/base/setupError.hpp"
#include "core/io/fileAside.hpp"
#include "core/io/wordReader.hpp"

#include <algorithm>
#include <cstdio>

namespace chesil
{

namespace
{

/// What a row says in a column.
class Field
{
public:
    Field(const WordReader& reader, const std::string& column, const std::string& text)
        : reader_(reader), column_(column), text_(text)
    {
    }

    std::string name() const
    {
        if (text_.empty())
        {
            throw fail("a name");
        }
        return text_;
    }

    double number() const
    {
        try
        {
            return reader_.number(text_);
        }
        catch (const SetupError& error)
        {
            throw fail(error.expected());
        }
    }

    double positive() const
    {
        const double value = number();
        if (!(value > 0))
        {
            throw fail("a number > 0");
        }
        return value;
    }

    bool flag() const
    {
        if (text_ != "0" && text_ != "1")
        {
            throw fail("0 or 1");
        }
        return text_ == "1";
    }

private:
    SetupError fail(const std::string& expected) const
    {
        return reader_.fail(column_ + " '" + text_ + "'", expected);
    }

    const WordReader& reader_;
    const std::string& column_;
    const std::string& text_;
};

struct Column
{
    std::string name;
    bool required;
    void (*read)(GrainRow&, const Field&);
};

const std::vector<Column> columns{
    {"shape", true, [](GrainRow& row, const Field& field) { row.shape = field.name(); }},
    {"size", false, [](GrainRow& row, const Field& field) { row.size = field.positive(); }},
    {"x", true, [](GrainRow& row, const Field& field) { row.position.x() = field.number(); }},
    {"y", true, [](GrainRow& row, const Field& field) { row.position.y() = field.number(); }},
    {"angle", false, [](GrainRow& row, const Field& field) { row.angle = field.number(); }},
    {"vx", false, [](GrainRow& row, const Field& field) { row.velocity.x() = field.number(); }},
    {"vy", false, [](GrainRow& row, const Field& field) { row.velocity.y() = field.number(); }},
    {"angularVelocity", false,
     [](GrainRow& row, const Field& field) { row.angularVelocity = field.number(); }},
    {"material", false, [](GrainRow& row, const Field& field) { row.material = field.name(); }},
    {"driven", false, [](GrainRow& row, const Field& field) { row.driven = field.flag(); }}};

std::string knownColumns()
{
    std::vector<std::string> names;
    for (const Column& column : columns)
    {
        names.push_back(column.name);
    }
    return listOfNames(names);
}

std::string withoutMargins(const std::string& text)
{
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The fields of the line with these words.
std::vector<std::string> fieldsOf(const std::vector<std::string>& words)
{
    std::string line;
    for (const std::string& word : words)
    {
        line += word + " ";
    }
    std::vector<std::string> fields;
    std::size_t start = 0;
    for (std::size_t comma = 0; comma != std::string::npos; start = comma + 1)
    {
        comma = line.find(',', start);
        fields.push_back(withoutMargins(line.substr(start, comma - start)));
    }
    return fields;
}

const Column& columnNamed(const WordReader& reader, const std::string& name)
{
    const auto column =
        std::find_if(columns.begin(), columns.end(), [&](const Column& one) { return one.name == name; });
    if (column == columns.end())
    {
        throw reader.fail("the column '" + name + "'", "one of " + knownColumns());
    }
    return *column;
}

std::vector<Column> readHeader(WordReader& reader)
{
    const std::string expected = "a header line of columns: shape, x, y and any others of " + knownColumns();
    const std::vector<std::string> names = fieldsOf(reader.next(expected));
    std::vector<Column> header;
    for (const std::string& name : names)
    {
        header.push_back(columnNamed(reader, name));
        if (std::count(names.begin(), names.end(), name) > 1)
        {
            throw reader.fail("the column '" + name + "' twice", "each column once");
        }
    }
    for (const Column& column : columns)
    {
        if (column.required && std::count(names.begin(), names.end(), column.name) == 0)
        {
            throw reader.fail("no column '" + column.name + "'", expected);
        }
    }
    return header;
}

GrainRow readRow(const WordReader& reader, const std::vector<Column>& header,
                 const std::vector<std::string>& words)
{
    const std::vector<std::string> fields = fieldsOf(words);
    if (fields.size() != header.size())
    {
        std::vector<std::string> names;
        for (const Column& column : header)
        {
            names.push_back(column.name);
        }
        throw reader.fail(std::to_string(fields.size()) + " fields",
                          std::to_string(header.size()) + ": " + listOfNames(names));
    }
    GrainRow row;
    row.line = reader.lineNumber();
    for (std::size_t i = 0; i < header.size(); ++i)
    {
        header[i].read(row, Field(reader, header[i].name, fields[i]));
    }
    return row;
}

/// Which of the columns that may be left out a table has.
struct TableWidth
{
    bool sizes = false;
    bool materials = false;
    bool driven = false;
};

TableWidth widthOf(const std::string& path, const std::vector<GrainRow>& rows)
{
    TableWidth width;
    if (!rows.empty())
    {
        width.sizes = rows.front().size.has_value();
        width.materials = !rows.front().material.empty();
    }
    for (const GrainRow& row : rows)
    {
        if (row.size.has_value() != width.sizes || row.material.empty() == width.materials)
        {
            throw SetupError(path, "size, material", "some rows with, some without", "all or none");
        }
        width.driven = width.driven || row.driven;
        try
        {
            requireTableName(row.shape);
            if (width.materials)
            {
                requireTableName(row.material);
            }
        }
        catch (const ValueError& error)
        {
            throw error.at(path, "shape, material");
        }
    }
    return width;
}

void writeNumber(std::ostream& file, double value)
{
    char text[32];
    std::snprintf(text, sizeof text, ",%.17g", value);
    file << text;
}

void writeRow(std::ostream& file, const TableWidth& width, const GrainRow& row)
{
    file << row.shape;
    if (width.sizes)
    {
        writeNumber(file, *row.size);
    }
    for (const double value : {row.position.x(), row.position.y(), row.angle, row.velocity.x(),
                               row.velocity.y(), row.angularVelocity})
    {
        writeNumber(file, value);
    }
    if (width.materials)
    {
        file << ',' << row.material;
    }
    if (width.driven)
    {
        file << ',' << row.driven;
    }
    file << '\n';
}

} // namespace

std::vector<GrainRow> readGrainTable(const std::string& path)
{
    WordReader reader(path);
    const std::vector<Column> header = readHeader(reader);
    std::vector<GrainRow> rows;
    std::vector<std::string> words = reader.next("a row a grain");
    while (!words.empty())
    {
        rows.push_back(readRow(reader, header, words));
        words = reader.nextOrNothing();
    }
    return rows;
}

void writeGrainTable(const std::string& path, const std::vector<GrainRow>& rows)
{
    const TableWidth width = widthOf(path, rows);
    writeAside(path,
               [&](std::ostream& file)
               {
                   file << "shape" << (width.sizes ? ",size" : "") << ",x,y,angle,vx,vy,angularVelocity"
                        << (width.materials ? ",material" : "") << (width.driven ? ",driven" : "") << '\n';
                   for (const GrainRow& row : rows)
                   {
                       writeRow(file, width, row);
                   }
               });
}

void requireTableName(const std::string& name)
{
    if (name.empty() || name.find_first_of(",#\"' \t\r\n\v\f") != std::string::npos)
    {
        throw ValueError("the name '" + name + "'",
                         "one word without comma, quotes and #, to stand in a table of grains");
    }
}

} // namespace chesil
