#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace chesil::test
{

/// A folder of its own for each test, gone at its end.
class TemporaryFolder : public testing::Test
{
protected:
    TemporaryFolder()
        : folder_(testing::TempDir() + "chesil_" + std::to_string(getpid()) + "_" +
                  testing::UnitTest::GetInstance()->current_test_info()->name())
    {
        std::filesystem::create_directories(folder_);
    }

    ~TemporaryFolder() override { std::filesystem::remove_all(folder_); }

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

    std::string folder_;
};

inline std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
}

inline void setContent(const std::string& path, const std::string& content)
{
    std::ofstream(path, std::ios::binary) << content;
}

/// What a call of `action` throws, as Error; fails the test if it throws nothing.
template <class Error, class Action>
Error errorOf(const Action& action)
{
    try
    {
        action();
    }
    catch (const Error& error)
    {
        return error;
    }
    ADD_FAILURE() << "not refused";
    throw std::logic_error("not refused");
}

} // namespace chesil::test
