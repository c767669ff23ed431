#pragma once

#include <functional>

namespace chesil::test
{

/// While it lives, the unit tests' calls of fsync come here instead of to the system: a test can look at what
/// is on disk at that time, let the call fail, or pass over it.
class FsyncHook
{
public:
    explicit FsyncHook(std::function<int(int)> instead);
    FsyncHook(const FsyncHook&) = delete;
    FsyncHook& operator=(const FsyncHook&) = delete;
    ~FsyncHook();
};

} // namespace chesil::test
