#include "core/io/checkpointFolder.hpp"

#include "unit/core/io/fsyncHook.hpp"
#include "unit/randomGrain.hpp"
#include "unit/temporaryFolder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <functional>
#include <iostream>
#include <thread>

using namespace chesil;

namespace
{

class CheckpointKilled : public test::TemporaryFolder
{
protected:
    CheckpointFolder checkpoints_{folder_};
};

/// Of a double for each step, so that a mix of two checkpoints would be seen.
CheckpointWriter sectionsOf(std::uint64_t step, std::size_t count)
{
    CheckpointWriter writer;
    writer.add("positions", std::vector<double>(count, static_cast<double>(step)));
    return writer;
}

/// Writes checkpoints as fast as it can until it is killed, and tells the number of each that is safe.
[[noreturn]] void writeForEver(const CheckpointFolder& checkpoints, std::uint64_t step, int pipe)
{
    constexpr std::size_t oneMegabyte = 1000 * 1000 / sizeof(double);
    for (;; ++step)
    {
        try
        {
            checkpoints.write(sectionsOf(step, oneMegabyte), step, 0);
        }
        catch (const std::exception& error)
        {
            std::cerr << error.what() << std::endl;
            _exit(1);
        }
        if (write(pipe, &step, sizeof(step)) != sizeof(step))
        {
            _exit(1);
        }
    }
}

/// Runs the writer for that long; false unless it lived until it was killed. `told` becomes the last step it
/// told.
bool runAndKill(const CheckpointFolder& checkpoints, std::chrono::microseconds life, std::uint64_t& told,
                int& count)
{
    int ends[2];
    if (pipe(ends) != 0)
    {
        return false;
    }
    const pid_t child = fork();
    if (child == 0)
    {
        close(ends[0]); // so that it ends with this process, too
        writeForEver(checkpoints, told + 1, ends[1]);
    }
    close(ends[1]);
    std::this_thread::sleep_for(life);
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    for (std::uint64_t step = 0; read(ends[0], &step, sizeof(step)) == sizeof(step); ++count)
    {
        told = step;
    }
    close(ends[0]);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
}

} // namespace

TEST_F(CheckpointKilled, leavesTheLastOneThatWasToldToBeSafe)
{
    constexpr int kills = 200;
    test::RandomSource random(200);
    std::uint64_t told = 0;
    int written = 0;
    int interrupted = 0;
    for (int i = 0; i < kills; ++i)
    {
        const std::chrono::microseconds life(random.integer(1000, 20000));
        ASSERT_TRUE(runAndKill(checkpoints_, life, told, written)) << "kill " << i;
        const std::vector<std::string> left = names();
        interrupted +=
            std::any_of(left.begin(), left.end(),
                        [](const std::string& name) { return name.find(".part") != std::string::npos; });

        const NewestCheckpoint newest = checkpoints_.newestValid();
        ASSERT_TRUE(newest.broken.empty()) << newest.broken.front();
        if (!newest.path)
        {
            ASSERT_EQ(told, 0u) << "kill " << i;
            continue;
        }
        CheckpointReader reader(*newest.path);
        const std::uint64_t step = reader.take<std::uint64_t>("step").at(0);
        ASSERT_GE(step, told) << "kill " << i;
        const std::vector<double> positions = reader.take<double>("positions");
        ASSERT_TRUE(std::all_of(positions.begin(), positions.end(),
                                [&](double x) { return x == static_cast<double>(step); }));
        told = step;
    }
    std::cout << kills << " kills, " << interrupted << " of them while a file was half written, " << written
              << " checkpoints of 1 MB told to be safe\n";
    EXPECT_GT(written, 0);
    EXPECT_GT(interrupted, 0);
}

TEST_F(CheckpointKilled, costs)
{
    using Clock = std::chrono::steady_clock;
    constexpr int times = 5;
    constexpr double megabytes = 32;
    const CheckpointWriter writer = sectionsOf(1, static_cast<std::size_t>(megabytes * 1e6 / sizeof(double)));
    const std::string path = folder_ + "/file";
    const auto speed = [&](const std::function<void()>& action)
    {
        double best = 0;
        for (int i = 0; i < times; ++i)
        {
            const Clock::time_point start = Clock::now();
            action();
            best = std::max(best, megabytes / std::chrono::duration<double>(Clock::now() - start).count());
        }
        return best;
    };
    const double safe = speed([&] { writer.write(path); });
    const double read = speed([&] { CheckpointReader reader(path); });
    const double checked = speed([&] { requireWholeCheckpoint(path); });
    const test::FsyncHook hook([](int) { return 0; });
    const double unsafe = speed([&] { writer.write(path); });
    std::cout << "best of " << times << " with " << megabytes << " MB: write with fsync " << safe
              << " MB/s, without " << unsafe << " MB/s, read " << read << " MB/s, check only " << checked
              << " MB/s\n";
}
