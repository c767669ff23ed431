#include "core/io/checkpointFolder.hpp"

#include "core/base/setupError.hpp"
#include "unit/core/io/fsyncHook.hpp"
#include "unit/core/io/fullDisk.hpp"
#include "unit/temporaryFolder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace chesil;
using test::contentOf;
using test::errorOf;
using test::setContent;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

std::string nameOf(int step)
{
    const std::string digits = std::to_string(step);
    return "checkpoint_" + std::string(20 - digits.size(), '0') + digits;
}

CheckpointWriter someSections()
{
    CheckpointWriter writer;
    writer.add("positions", std::vector<double>(1000, 0.5));
    return writer;
}

class CheckpointFolderTest : public test::TemporaryFolder
{
protected:
    void write(int step) const
    {
        checkpoints_.write(someSections(), static_cast<std::uint64_t>(step), 0.25 * step);
    }
    std::string pathOf(int step) const { return folder_ + "/" + nameOf(step); }
    void breakFile(int step) const
    {
        std::string bytes = contentOf(pathOf(step));
        bytes[100] = static_cast<char>(bytes[100] ^ 1);
        setContent(pathOf(step), bytes);
    }

    CheckpointFolder checkpoints_{folder_};
};

} // namespace

TEST_F(CheckpointFolderTest, addsStepAndTime)
{
    write(30);
    CheckpointReader reader(checkpoints_.newestValid().path.value());
    EXPECT_THAT(reader.take<std::uint64_t>("step"), ElementsAre(30u));
    EXPECT_THAT(reader.take<double>("time"), ElementsAre(7.5));
    EXPECT_EQ(reader.take<double>("positions").size(), 1000u);
    reader.finish();

    CheckpointWriter writer;
    writer.add("step", std::vector<double>{1});
    EXPECT_THROW(checkpoints_.write(writer, 40, 0), ValueError);
}

TEST_F(CheckpointFolderTest, keepsTheNewestTwoByTheirNumbers)
{
    for (const int step : {8, 9, 10, 100})
    {
        write(step);
    }
    EXPECT_THAT(names(), ElementsAre(nameOf(10), nameOf(100)));
    write(100);
    EXPECT_THAT(names(), ElementsAre(nameOf(10), nameOf(100)));
    EXPECT_EQ(checkpoints_.newestValid().path, pathOf(100));
}

TEST_F(CheckpointFolderTest, removesNothingBeforeTheNewOneIsSafe)
{
    write(1);
    write(2);
    std::vector<std::vector<std::string>> seen;
    const test::FsyncHook hook(
        [&](int)
        {
            seen.push_back(names());
            return 0;
        });
    write(3);
    EXPECT_THAT(seen, ElementsAre(ElementsAre(nameOf(1), nameOf(2), nameOf(3) + ".part"),
                                  ElementsAre(nameOf(1), nameOf(2), nameOf(3))));
    EXPECT_THAT(names(), ElementsAre(nameOf(2), nameOf(3)));
}

TEST_F(CheckpointFolderTest, brokenOnesDoNotCountAsKept)
{
    write(1);
    write(2);
    breakFile(2);
    write(3);
    EXPECT_THAT(names(), ElementsAre(nameOf(1), nameOf(2), nameOf(3)));
    write(4);
    EXPECT_THAT(names(), ElementsAre(nameOf(3), nameOf(4)));
}

TEST_F(CheckpointFolderTest, theNewestIsTheNewestWholeOne)
{
    EXPECT_EQ(checkpoints_.newestValid().path, std::nullopt);
    EXPECT_TRUE(checkpoints_.newestValid().broken.empty());
    write(1);
    write(2);
    setContent(pathOf(3), contentOf(pathOf(2)).substr(0, 500));
    breakFile(2);
    const NewestCheckpoint newest = checkpoints_.newestValid();
    EXPECT_EQ(newest.path, pathOf(1));
    EXPECT_THAT(newest.broken, ElementsAre(testing::AllOf(HasSubstr(nameOf(3)), HasSubstr("cut short")),
                                           testing::AllOf(HasSubstr(nameOf(2)), HasSubstr("checksum"))));
    breakFile(1);
    EXPECT_EQ(checkpoints_.newestValid().path, std::nullopt);
    EXPECT_EQ(checkpoints_.newestValid().broken.size(), 3u);
}

TEST_F(CheckpointFolderTest, aRunThatDidNotStartFromTheNewestIsRefused)
{
    write(1);
    write(5);
    const SetupError error = errorOf<SetupError>([&] { write(4); });
    EXPECT_EQ(error.file(), pathOf(5));
    EXPECT_THAT(error.found(), HasSubstr("later one than 4"));
    EXPECT_THAT(names(), ElementsAre(nameOf(1), nameOf(5)));
    breakFile(5);
    write(4);
    EXPECT_THAT(names(), ElementsAre(nameOf(1), nameOf(4), nameOf(5)));
    EXPECT_EQ(checkpoints_.newestValid().path, pathOf(4));
}

TEST_F(CheckpointFolderTest, removesWhatKilledRunsLeftButNothingElse)
{
    const std::vector<std::string> others{"checkpoint_7",     "checkpoint_.part",
                                          "grains.part",      "checkpoint_" + std::string(20, '9'),
                                          nameOf(1) + ".txt", ".part"};
    for (const std::string& other : others)
    {
        setContent(folder_ + "/" + other, "other");
    }
    setContent(pathOf(9) + ".part", "half");
    for (const int step : {1, 2, 3})
    {
        write(step);
    }
    std::vector<std::string> expected = others;
    expected.insert(expected.end(), {nameOf(2), nameOf(3)});
    EXPECT_THAT(names(), testing::UnorderedElementsAreArray(expected));
}

TEST_F(CheckpointFolderTest, aFullDiskLeavesTheOldOnes)
{
    write(1);
    write(2);
    test::expectRefusedOnFullDisk([&] { write(3); });
    EXPECT_THAT(names(), ElementsAre(nameOf(1), nameOf(2)));
    EXPECT_EQ(checkpoints_.newestValid().path, pathOf(2));
}

TEST_F(CheckpointFolderTest, aMissingFolderIsNamed)
{
    const CheckpointFolder none(folder_ + "/none");
    const SetupError error = errorOf<SetupError>([&] { none.write(someSections(), 1, 0); });
    EXPECT_EQ(error.file(), folder_ + "/none");
    EXPECT_THAT(error.found(), HasSubstr("No such file"));
    EXPECT_THROW(none.newestValid(), SetupError);
}

TEST_F(CheckpointFolderTest, aFolderWithoutRightsIsNamed)
{
    if (geteuid() == 0)
    {
        GTEST_SKIP() << "root may write anywhere";
    }
    write(1);
    std::filesystem::permissions(folder_,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const SetupError error = errorOf<SetupError>([&] { write(2); });
    std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
    EXPECT_THAT(error.found(), HasSubstr("Permission denied"));
    EXPECT_EQ(error.file(), pathOf(2));
    EXPECT_THAT(names(), ElementsAre(nameOf(1)));
}
