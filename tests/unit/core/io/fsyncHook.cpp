#include "unit/core/io/fsyncHook.hpp"

#include <sys/syscall.h>
#include <unistd.h>

namespace
{

std::function<int(int)>& insteadOfFsync()
{
    static std::function<int(int)> instead;
    return instead;
}

} // namespace

/// Stands before the one of the C library for the whole program.
extern "C" int fsync(int file)
{
    return insteadOfFsync() ? insteadOfFsync()(file) : static_cast<int>(syscall(SYS_fsync, file));
}

namespace chesil::test
{

FsyncHook::FsyncHook(std::function<int(int)> instead) { insteadOfFsync() = std::move(instead); }
FsyncHook::~FsyncHook() { insteadOfFsync() = nullptr; }

} // namespace chesil::test
