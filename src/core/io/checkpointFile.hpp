#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace chesil
{

/// Checkpoint files: named arrays of numbers, kept to the bit. Layout, in the bytes of the machine that wrote
/// it:
///
///     32 bytes   "chesil checkpoint 1\n", filled up with zeros
///      8 bytes   byte order mark, 0x0102030405060708
///      8 bytes   size of the whole file
///     sections   each: type (8 bytes of text, filled up with zeros), length of the name (8), count of
///     numbers (8),
///                name, numbers
///      8 bytes   CRC-64/XZ of all before it
///
/// Text of the type of a section's numbers; there is none for other types, so that they do not compile.
template <class Number>
struct CheckpointType;
template <>
struct CheckpointType<double>
{
    static constexpr const char* name = "float64";
};
template <>
struct CheckpointType<std::int32_t>
{
    static constexpr const char* name = "int32";
};
template <>
struct CheckpointType<std::int64_t>
{
    static constexpr const char* name = "int64";
};
template <>
struct CheckpointType<std::uint64_t>
{
    static constexpr const char* name = "uint64";
};
template <>
struct CheckpointType<char>
{
    static constexpr const char* name = "char";
};

/// Collects the sections of a checkpoint and writes them.
class CheckpointWriter
{
public:
    /// Copies the numbers. Throws ValueError if the name is empty or was there before.
    template <class Number>
    void add(const std::string& name, const std::vector<Number>& numbers)
    {
        addSection(name, CheckpointType<Number>::name, numbers.data(), numbers.size(), sizeof(Number));
    }

    /// As a section of char.
    void addText(const std::string& name, const std::string& text)
    {
        addSection(name, CheckpointType<char>::name, text.data(), text.size(), 1);
    }

    /// By writeDurably: a whole file or none. Throws SetupError if that fails; a file that was there stays.
    void write(const std::string& path) const;

    /// Of the file [bytes].
    std::size_t size() const;

private:
    void addSection(const std::string& name, const std::string& type, const void* numbers, std::size_t count,
                    std::size_t width);

    /// As they stand in the file.
    std::vector<std::string> sections_;
    std::size_t sectionsSize_ = 0;
    std::set<std::string> names_;
};

/// Reads a checkpoint as a whole, then gives its sections out. All its errors are SetupErrors that name the
/// file and the section.
class CheckpointReader
{
public:
    /// Throws SetupError unless the file is there, of this version and byte order, of the size that it tells,
    /// and its checksum holds.
    explicit CheckpointReader(const std::string& path);

    const std::string& path() const { return path_; }

    /// A section's numbers, once. Throws SetupError if there is none of that name and type, or it was taken
    /// before.
    template <class Number>
    std::vector<Number> take(const std::string& name)
    {
        const Section section = takeSection(name, CheckpointType<Number>::name);
        std::vector<Number> numbers(section.count);
        copyTo(numbers.data(), section);
        return numbers;
    }

    /// As take, of a section of char.
    std::string takeText(const std::string& name)
    {
        const std::vector<char> text = take<char>(name);
        return std::string(text.begin(), text.end());
    }

    /// Throws SetupError if sections were not taken: nobody here knows what they are for.
    void finish() const;

private:
    struct Section
    {
        std::string type;
        std::size_t begin = 0;
        std::size_t count = 0;
        std::size_t width = 0;
        bool taken = false;
    };

    void parse();
    Section takeSection(const std::string& name, const std::string& type);
    std::string knownNames() const;
    void copyTo(void* numbers, const Section& section) const
    {
        if (section.count > 0)
        {
            std::memcpy(numbers, bytes_.data() + section.begin, section.count * section.width);
        }
    }

    std::string path_;
    std::vector<char> bytes_;
    std::map<std::string, Section> sections_;
};

/// As the constructor of CheckpointReader, but keeps nothing: throws the same SetupError unless the file is
/// whole.
void requireWholeCheckpoint(const std::string& path);

} // namespace chesil
