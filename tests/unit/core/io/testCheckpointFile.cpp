#include "core/io/checkpointFile.hpp"

#include "core/base/setupError.hpp"
#include "core/io/crc64.hpp"
#include "unit/randomGrain.hpp"
#include "unit/temporaryFolder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

using namespace chesil;
using test::contentOf;
using test::errorOf;
using test::setContent;
using testing::HasSubstr;

namespace
{

class CheckpointFile : public test::TemporaryFolder
{
protected:
    /// A small file with sections of three types.
    void writeSmall() const
    {
        CheckpointWriter writer;
        writer.add("positions", std::vector<double>{1.5, -2.5});
        writer.add("flags", std::vector<std::int32_t>{7});
        writer.addText("law", "linear");
        writer.write(path_);
    }

    SetupError errorOfReading() const
    {
        return errorOf<SetupError>([&] { CheckpointReader reader(path_); });
    }

    /// The file with one word changed and a checksum that holds: what CheckpointWriter did not write.
    void forge(std::size_t place, std::uint64_t word) const
    {
        std::string bytes = contentOf(path_);
        std::memcpy(bytes.data() + place, &word, sizeof(word));
        Crc64 sum;
        sum.add(bytes.data(), bytes.size() - sizeof(word));
        const std::uint64_t value = sum.value();
        std::memcpy(bytes.data() + bytes.size() - sizeof(value), &value, sizeof(value));
        setContent(path_, bytes);
    }

    std::string path_ = folder_ + "/checkpoint";
};

template <class To, class From>
To bitsAs(From from)
{
    static_assert(sizeof(To) == sizeof(From));
    To to;
    std::memcpy(&to, &from, sizeof(to));
    return to;
}

template <class Number>
std::vector<std::uint64_t> bitsOf(const std::vector<Number>& numbers)
{
    std::vector<std::uint64_t> bits;
    for (const Number number : numbers)
    {
        bits.push_back(bitsAs<std::uint64_t>(number));
    }
    return bits;
}

} // namespace

TEST_F(CheckpointFile, givesAllTypesBackToTheBit)
{
    using Limits = std::numeric_limits<double>;
    test::RandomSource random(3);
    std::vector<double> doubles{
        0.0, -0.0, Limits::denorm_min(), -Limits::min() / 2, Limits::infinity(), -Limits::max(), 0.1};
    for (const std::uint64_t bits : {0x7FF8000000000123u, 0xFFF80000DEADBEEFu, 0x7FF0000000000001u})
    {
        doubles.push_back(bitsAs<double>(bits)); // NaNs with payload, quiet and signalling
    }
    for (int i = 0; i < 20000; ++i)
    {
        doubles.push_back(random.uniform(-1, 1)); // more than the reader takes at once
    }
    const std::vector<std::int32_t> small{0, -1, INT32_MIN, INT32_MAX};
    const std::vector<std::int64_t> large{0, -1, INT64_MIN, INT64_MAX};
    const std::vector<std::uint64_t> natural{0, 1, UINT64_MAX};
    const std::string text("line\n\0after zero", 16);

    CheckpointWriter writer;
    writer.add("doubles", doubles);
    writer.add("int32", small);
    writer.add("int64", large);
    writer.add("uint64", natural);
    writer.addText("text with spaces in its name", text);
    writer.add("none", std::vector<double>{});
    writer.write(path_);
    EXPECT_EQ(contentOf(path_).size(), writer.size());

    CheckpointReader reader(path_);
    EXPECT_EQ(bitsOf(reader.take<double>("doubles")), bitsOf(doubles));
    EXPECT_EQ(reader.take<std::int32_t>("int32"), small);
    EXPECT_EQ(reader.take<std::int64_t>("int64"), large);
    EXPECT_EQ(reader.take<std::uint64_t>("uint64"), natural);
    EXPECT_EQ(reader.takeText("text with spaces in its name"), text);
    EXPECT_TRUE(reader.take<double>("none").empty());
    EXPECT_NO_THROW(reader.finish());
}

TEST_F(CheckpointFile, withoutSectionsIsWhole)
{
    CheckpointWriter().write(path_);
    CheckpointReader reader(path_);
    reader.finish();
    EXPECT_THAT(errorOf<SetupError>([&] { reader.take<double>("x"); }).found(), HasSubstr("none at all"));
}

TEST_F(CheckpointFile, theSameSectionsGiveTheSameBytes)
{
    writeSmall();
    const std::string first = contentOf(path_);
    writeSmall();
    EXPECT_EQ(contentOf(path_), first);
    EXPECT_THAT(first, testing::StartsWith("chesil checkpoint 3\n"));
}

TEST_F(CheckpointFile, everyChangeOfOneByteIsFound)
{
    writeSmall();
    const std::string whole = contentOf(path_);
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    const auto put = [&](std::size_t place, int byte)
    {
        file.seekp(static_cast<std::streamoff>(place));
        file.put(static_cast<char>(byte)).flush();
    };
    for (std::size_t place = 0; place < whole.size(); ++place)
    {
        for (int change = 1; change < 256; ++change)
        {
            put(place, whole[place] ^ change);
            ASSERT_THROW(CheckpointReader reader(path_), SetupError) << "byte " << place << " by " << change;
        }
        put(place, whole[place]);
    }
    EXPECT_NO_THROW(CheckpointReader reader(path_));
}

TEST_F(CheckpointFile, everyOtherLengthIsFound)
{
    writeSmall();
    const std::string whole = contentOf(path_);
    for (std::size_t length = 0; length < whole.size(); ++length)
    {
        setContent(path_, whole.substr(0, length));
        ASSERT_THAT(errorOfReading().what(), HasSubstr("cut short")) << "length " << length;
    }
    setContent(path_, whole + '\0');
    EXPECT_EQ(errorOfReading().entry(), "size");
}

TEST_F(CheckpointFile, anotherVersionByteOrderOrKindOfFileIsNamed)
{
    writeSmall();
    const std::string whole = contentOf(path_);
    std::string other = whole;
    other.replace(18, 2, "12\n");
    other.erase(31, 1);
    setContent(path_, other);
    EXPECT_EQ(errorOfReading().entry(), "version");
    EXPECT_EQ(errorOfReading().found(), "'12'");

    other = whole;
    std::reverse(other.begin() + 32, other.begin() + 40);
    setContent(path_, other);
    EXPECT_EQ(errorOfReading().entry(), "byte order mark");
    EXPECT_EQ(errorOfReading().found(), "0x807060504030201");

    setContent(path_, "grains 2\n" + std::string(100, ' '));
    EXPECT_EQ(errorOfReading().entry(), "first line");
    EXPECT_EQ(errorOfReading().file(), path_);
}

TEST_F(CheckpointFile, aMissingFileAndAFolderAreNamed)
{
    EXPECT_THAT(errorOfReading().found(), HasSubstr("No such file"));
    std::filesystem::create_directory(path_);
    EXPECT_THAT(errorOfReading().found(), HasSubstr("Is a directory"));
}

TEST_F(CheckpointFile, sectionsThatDoNotFitTheFileAreFoundInSpiteOfAGoodChecksum)
{
    writeSmall();
    const std::string whole = contentOf(path_);
    const std::size_t begin = 48;
    // The last one times 8 bytes is 2^64 more than what is there.
    for (const std::uint64_t wrong : {std::uint64_t{1000}, UINT64_MAX, UINT64_MAX / 8 + 3})
    {
        setContent(path_, whole);
        forge(begin + 8, wrong);
        EXPECT_EQ(errorOfReading().entry(), "sections") << "length of the name " << wrong;
        setContent(path_, whole);
        forge(begin + 16, wrong);
        EXPECT_EQ(errorOfReading().entry(), "sections") << "count " << wrong;
    }
    setContent(path_, whole);
    forge(begin, 0x003631746C6F6166);
    EXPECT_EQ(errorOfReading().entry(), "section 'positions'");
    EXPECT_EQ(errorOfReading().found(), "the type 'faolt16'");
}

TEST_F(CheckpointFile, aSectionThatIsMissingOfAnotherTypeOrTakenBeforeIsNamed)
{
    writeSmall();
    CheckpointReader reader(path_);
    const SetupError missing = errorOf<SetupError>([&] { reader.take<double>("velocities"); });
    EXPECT_EQ(missing.file(), path_);
    EXPECT_EQ(missing.entry(), "section 'velocities'");
    EXPECT_THAT(missing.found(), HasSubstr("flags, law, positions"));
    EXPECT_THAT(missing.expected(), HasSubstr("float64"));

    const SetupError ofOtherType = errorOf<SetupError>([&] { reader.take<std::int64_t>("flags"); });
    EXPECT_EQ(ofOtherType.entry(), "section 'flags'");
    EXPECT_EQ(ofOtherType.found(), "1 of type int32");
    EXPECT_EQ(ofOtherType.expected(), "type int64");

    EXPECT_EQ(reader.take<std::int32_t>("flags").size(), 1u) << "a refusal takes nothing";
    EXPECT_THAT(errorOf<SetupError>([&] { reader.take<std::int32_t>("flags"); }).found(),
                HasSubstr("taken before"));
}

TEST_F(CheckpointFile, sectionsThatNobodyTookAreNamed)
{
    writeSmall();
    CheckpointReader reader(path_);
    reader.takeText("law");
    const SetupError error = errorOf<SetupError>([&] { reader.finish(); });
    EXPECT_EQ(error.entry(), "section 'flags'");
    EXPECT_THAT(error.found(), HasSubstr("flags, positions"));
    EXPECT_EQ(error.expected(), "only law");
}

TEST(CheckpointWriter, refusesNamesThatAreEmptyOrTwice)
{
    CheckpointWriter writer;
    writer.addText("law", "linear");
    EXPECT_THAT(errorOf<ValueError>([&] { writer.addText("law", "other"); }).found(), HasSubstr("'law'"));
    EXPECT_THROW(writer.addText("", "text"), ValueError);
}
