#include "core/io/checkpointFile.hpp"

#include "core/base/setupError.hpp"
#include "core/io/checkpointFrame.hpp"
#include "core/io/durableFile.hpp"

#include <algorithm>

namespace chesil
{

namespace
{

constexpr std::size_t typeLength = 8;

/// Of one number of a type [bytes]; 0 for an unknown type.
std::size_t widthOf(const std::string& type)
{
    static const std::map<std::string, std::size_t> widths{
        {CheckpointType<double>::name, 8},       {CheckpointType<std::int32_t>::name, 4},
        {CheckpointType<std::int64_t>::name, 8}, {CheckpointType<std::uint64_t>::name, 8},
        {CheckpointType<char>::name, 1},
    };
    const auto found = widths.find(type);
    return found == widths.end() ? 0 : found->second;
}

void append(std::string& bytes, const void* more, std::size_t count)
{
    bytes.append(static_cast<const char*>(more), count);
}

void appendCount(std::string& bytes, std::uint64_t count) { append(bytes, &count, sizeof(count)); }

/// Goes through the bytes between header and checksum; a checksum that holds does not tell that a file was
/// made by CheckpointWriter, so each step is checked.
class SectionScanner
{
public:
    SectionScanner(const std::string& path, const std::vector<char>& bytes) : path_(path), bytes_(bytes) {}

    bool atEnd() const { return place_ == bytes_.size(); }
    std::size_t place() const { return place_; }

    std::string text(std::uint64_t length)
    {
        const std::size_t begin = place_;
        skip(length, 1);
        return std::string(bytes_.data() + begin, static_cast<std::size_t>(length));
    }

    std::uint64_t count()
    {
        std::uint64_t value = 0;
        const std::size_t begin = place_;
        skip(1, sizeof(value));
        std::memcpy(&value, bytes_.data() + begin, sizeof(value));
        return value;
    }

    void skip(std::uint64_t count, std::size_t width)
    {
        const std::size_t left = bytes_.size() - place_;
        if (count > left / width)
        {
            throw SetupError(path_, "sections", "one that is longer than the file",
                             "sections that fill the file, as CheckpointWriter writes them");
        }
        place_ += static_cast<std::size_t>(count) * width;
    }

private:
    const std::string& path_;
    const std::vector<char>& bytes_;
    std::size_t place_ = 0;
};

std::string sectionCalled(const std::string& name) { return "section '" + name + "'"; }

} // namespace

void CheckpointWriter::addSection(const std::string& name, const std::string& type, const void* numbers,
                                  std::size_t count, std::size_t width)
{
    if (name.empty() || !names_.insert(name).second)
    {
        throw ValueError(name.empty() ? "a section without a name" : "a second " + sectionCalled(name),
                         "a name of its own for each section");
    }
    std::string section = type;
    section.resize(typeLength, '\0');
    section.reserve(typeLength + 2 * sizeof(std::uint64_t) + name.size() + count * width);
    appendCount(section, name.size());
    appendCount(section, count);
    section += name;
    if (count > 0)
    {
        append(section, numbers, count * width);
    }
    sectionsSize_ += section.size();
    sections_.push_back(std::move(section));
}

void CheckpointWriter::write(const std::string& path) const
{
    const std::string header = checkpointHeader(size());
    std::vector<std::string_view> pieces{header};
    pieces.insert(pieces.end(), sections_.begin(), sections_.end());
    const std::string checksum = checkpointChecksum(pieces);
    pieces.push_back(checksum);
    writeDurably(path, pieces);
}

std::size_t CheckpointWriter::size() const { return sectionsSize_ + checkpointFrameSize; }

CheckpointReader::CheckpointReader(const std::string& path) : path_(path)
{
    readCheckedSections(path, [&](const char* bytes, std::size_t count)
                        { bytes_.insert(bytes_.end(), bytes, bytes + count); });
    parse();
}

void CheckpointReader::parse()
{
    SectionScanner scanner(path_, bytes_);
    while (!scanner.atEnd())
    {
        Section section;
        section.type = scanner.text(typeLength);
        section.type.erase(std::min(section.type.find('\0'), typeLength));
        const std::uint64_t nameLength = scanner.count();
        const std::uint64_t count = scanner.count();
        const std::string name = scanner.text(nameLength);
        section.width = widthOf(section.type);
        if (section.width == 0)
        {
            throw SetupError(path_, sectionCalled(name), "the type '" + section.type + "'",
                             "one of float64, int32, int64, uint64, char");
        }
        section.begin = scanner.place();
        section.count = static_cast<std::size_t>(count);
        scanner.skip(count, section.width);
        if (!sections_.emplace(name, section).second)
        {
            throw SetupError(path_, sectionCalled(name), "it twice", "a name of its own for each section");
        }
    }
}

CheckpointReader::Section CheckpointReader::takeSection(const std::string& name, const std::string& type)
{
    const auto found = sections_.find(name);
    if (found == sections_.end())
    {
        throw SetupError(path_, sectionCalled(name), "no section of that name among " + knownNames(),
                         "a section of " + type);
    }
    Section& section = found->second;
    if (section.type != type)
    {
        throw SetupError(path_, sectionCalled(name),
                         std::to_string(section.count) + " of type " + section.type, "type " + type);
    }
    if (section.taken)
    {
        throw SetupError(path_, sectionCalled(name), "that it was taken before", "each section taken once");
    }
    section.taken = true;
    return section;
}

void CheckpointReader::finish() const
{
    std::vector<std::string> taken;
    std::vector<std::string> left;
    for (const auto& [name, section] : sections_)
    {
        (section.taken ? taken : left).push_back(name);
    }
    if (!left.empty())
    {
        throw SetupError(path_, sectionCalled(left.front()),
                         std::to_string(left.size()) + " unknown sections: " + listOfNames(left),
                         "only " + listOfNames(taken));
    }
}

std::string CheckpointReader::knownNames() const
{
    std::vector<std::string> names;
    for (const auto& entry : sections_)
    {
        names.push_back(entry.first);
    }
    return names.empty() ? "none at all" : listOfNames(names);
}

void requireWholeCheckpoint(const std::string& path)
{
    readCheckedSections(path, [](const char*, std::size_t) {});
}

} // namespace chesil
