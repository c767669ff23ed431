#pragma once

#include "core/base/setupError.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>

namespace chesil::test
{

/// Runs the action in a child process whose files cannot grow beyond 4096 bytes, as if the disk were full
/// then. Fails the test unless it throws SetupError with the system's reason.
inline void expectRefusedOnFullDisk(const std::function<void()>& action)
{
    const pid_t child = fork();
    if (child == 0)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit most{4096, 4096};
        setrlimit(RLIMIT_FSIZE, &most);
        try
        {
            action();
        }
        catch (const SetupError& error)
        {
            _exit(error.found().find("File too large") != std::string::npos ? 1 : 2);
        }
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 1) << "0: not refused, 2: another message";
}

} // namespace chesil::test
