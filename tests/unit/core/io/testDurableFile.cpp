#include "core/io/durableFile.hpp"

#include "core/base/setupError.hpp"
#include "unit/core/io/fsyncHook.hpp"
#include "unit/core/io/fullDisk.hpp"
#include "unit/temporaryFolder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>

using namespace chesil;
using test::contentOf;
using test::errorOf;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

class DurableFile : public test::TemporaryFolder
{
protected:
    void write(const std::string& text) { writeDurably(path_, {text}); }

    std::string path_ = folder_ + "/file";
};

bool isFolder(int file)
{
    struct stat status;
    return fstat(file, &status) == 0 && S_ISDIR(status.st_mode);
}

} // namespace

TEST_F(DurableFile, joinsThePiecesAndReplacesTheOldFile)
{
    write("old, and longer");
    writeDurably(path_, {"ne", "", "w"});
    EXPECT_EQ(contentOf(path_), "new");
    EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(DurableFile, theDiskHasTheContentBeforeTheNameAndTheNameBeforeTheReturn)
{
    write("old");
    std::vector<std::string> calls;
    {
        const test::FsyncHook hook(
            [&](int file)
            {
                calls.push_back((isFolder(file) ? "folder, " : "file, ") + contentOf(path_));
                return 0;
            });
        write("new");
    }
    EXPECT_THAT(calls, ElementsAre("file, old", "folder, new"));
}

TEST_F(DurableFile, aDiskThatFailsLeavesTheOldFileAndNoRest)
{
    write("old");
    const test::FsyncHook hook(
        [](int)
        {
            errno = EIO;
            return -1;
        });
    EXPECT_THAT(errorOf<SetupError>([&] { write("new"); }).found(), HasSubstr("Input/output error"));
    EXPECT_EQ(contentOf(path_), "old");
    EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(DurableFile, aFolderThatFailsIsReported)
{
    const auto failForFolders = [](int reason)
    {
        return [reason](int file)
        {
            errno = reason;
            return isFolder(file) ? -1 : 0;
        };
    };
    {
        const test::FsyncHook hook(failForFolders(EIO));
        EXPECT_THAT(errorOf<SetupError>([&] { write("new"); }).found(), HasSubstr("Input/output error"));
    }
    const test::FsyncHook hook(failForFolders(EINVAL));
    EXPECT_NO_THROW(write("new")) << "a network drive that cannot wait for folders";
}

TEST_F(DurableFile, aFullDiskIsNamed)
{
    if (!std::filesystem::exists("/dev/full"))
    {
        GTEST_SKIP() << "no device that is always full";
    }
    write("old");
    std::filesystem::create_symlink("/dev/full", path_ + partSuffix);
    EXPECT_THAT(errorOf<SetupError>([&] { write("new"); }).found(), HasSubstr("No space left"));
    EXPECT_EQ(contentOf(path_), "old");
    EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(DurableFile, aDiskThatIsFullHalfwayLeavesTheOldFileAndNoRest)
{
    write("old");
    test::expectRefusedOnFullDisk([&] { write(std::string(10000, 'x')); });
    EXPECT_EQ(contentOf(path_), "old");
    EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(DurableFile, aFolderThatDoesNotExistIsNamed)
{
    path_ = folder_ + "/none/file";
    const SetupError error = errorOf<SetupError>([&] { write("new"); });
    EXPECT_EQ(error.file(), path_);
    EXPECT_THAT(error.found(), HasSubstr("No such file"));
    EXPECT_THAT(error.expected(), HasSubstr("written"));
}

TEST_F(DurableFile, aFolderWithoutRightsIsNamed)
{
    if (geteuid() == 0)
    {
        GTEST_SKIP() << "root may write anywhere";
    }
    write("old");
    std::filesystem::permissions(folder_,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    EXPECT_THAT(errorOf<SetupError>([&] { write("new"); }).found(), HasSubstr("Permission denied"));
    std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
    EXPECT_EQ(contentOf(path_), "old");
}

TEST_F(DurableFile, aFailedRenameLeavesNoRest)
{
    std::filesystem::create_directories(path_ + "/occupied");
    EXPECT_THROW(write("new"), SetupError);
    EXPECT_THAT(names(), ElementsAre("file"));
}
