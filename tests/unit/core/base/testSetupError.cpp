#include "core/base/setupError.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

using namespace chesil;
using testing::StartsWith;

TEST(SetupError, showsAFileBelowThisFolderRelativeToIt)
{
    const std::filesystem::path here = std::filesystem::current_path();
    const std::string below = here / "checkpoints" / "checkpoint_1";
    const SetupError error(below, "size", "0", "1");
    EXPECT_STREQ(error.what(), "file checkpoints/checkpoint_1, entry size: found 0; expected 1");
    EXPECT_EQ(error.file(), below);
    EXPECT_THAT(ValueError("0", "1").at(here / "a" / ".." / "b", "size").what(), StartsWith("file b, "));
}

TEST(SetupError, showsOtherFilesAsGiven)
{
    const std::filesystem::path here = std::filesystem::current_path();
    if (here == here.root_path())
    {
        GTEST_SKIP() << "all files are below the root";
    }
    for (const std::string& file :
         {std::string("constant/chesilProperties"), std::string("../case"), std::string(""), here.string(),
          (here / ".." / "x").string(), here.string() + "x/y"})
    {
        EXPECT_THAT(SetupError(file, "size", "0", "1").what(), StartsWith("file " + file + ", entry"));
    }
}
