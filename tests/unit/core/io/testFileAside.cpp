#include "core/io/fileAside.hpp"

#include "core/base/setupError.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace chesil;
using testing::HasSubstr;

namespace
{

/// A folder of its own for each test, gone at its end.
class FileAside : public testing::Test
{
protected:
    FileAside()
        : folder_(testing::TempDir() + "chesil_" + std::to_string(getpid()) + "_" +
                  testing::UnitTest::GetInstance()->current_test_info()->name()),
          path_(folder_ + "/file.txt")
    {
        std::filesystem::create_directories(folder_);
    }

    ~FileAside() override { std::filesystem::remove_all(folder_); }

    std::string content() const
    {
        std::ostringstream text;
        text << std::ifstream(path_).rdbuf();
        return text.str();
    }

    /// Names in the folder, sorted.
    std::vector<std::string> names() const
    {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(folder_))
        {
            found.push_back(entry.path().filename());
        }
        std::sort(found.begin(), found.end());
        return found;
    }

    void write(const std::string& text)
    {
        writeAside(path_, [&](std::ostream& file) { file << text; });
    }

    std::string folder_;
    std::string path_;
};

} // namespace

TEST_F(FileAside, replacesTheOldFileAsAWhole)
{
    write("old, and longer");
    writeAside(path_,
               [&](std::ostream& file)
               {
                   file << "new" << std::flush;
                   EXPECT_EQ(content(), "old, and longer") << "while the new one is being written";
               });
    EXPECT_EQ(content(), "new");
    EXPECT_THAT(names(), testing::ElementsAre("file.txt"));
}

TEST_F(FileAside, aFolderThatDoesNotExistIsNamed)
{
    try
    {
        writeAside(folder_ + "/none/file.txt", [](std::ostream&) {});
        FAIL() << "not refused";
    }
    catch (const SetupError& error)
    {
        EXPECT_EQ(error.file(), folder_ + "/none/file.txt");
        EXPECT_THAT(error.found(), HasSubstr("No such file"));
        EXPECT_THAT(error.expected(), HasSubstr("written"));
    }
}

TEST_F(FileAside, aFolderWithoutRightsIsRefused)
{
    if (geteuid() == 0)
    {
        GTEST_SKIP() << "root may write anywhere";
    }
    write("old");
    std::filesystem::permissions(folder_,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    EXPECT_THROW(write("new"), SetupError);
    std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
    EXPECT_EQ(content(), "old");
}

TEST_F(FileAside, aFullDiskLeavesTheOldFileAndNoRest)
{
    if (!std::filesystem::exists("/dev/full"))
    {
        GTEST_SKIP() << "no device that is always full";
    }
    write("old");
    std::filesystem::create_symlink("/dev/full", path_ + ".part");
    EXPECT_THROW(write("new"), SetupError);
    EXPECT_EQ(content(), "old");
    EXPECT_THAT(names(), testing::ElementsAre("file.txt"));
}

TEST_F(FileAside, aFailedRenameLeavesNoRest)
{
    std::filesystem::create_directories(path_ + "/occupied");
    EXPECT_THROW(write("new"), SetupError);
    EXPECT_THAT(names(), testing::ElementsAre("file.txt"));
}

TEST_F(FileAside, aFailureOfTheContentPassesOnAndLeavesNoRest)
{
    write("old");
    const auto broken = [](std::ostream& file)
    {
        file << "half";
        throw ValueError("something", "something else");
    };
    EXPECT_THROW(writeAside(path_, broken), ValueError);
    EXPECT_EQ(content(), "old");
    EXPECT_THAT(names(), testing::ElementsAre("file.txt"));
}
