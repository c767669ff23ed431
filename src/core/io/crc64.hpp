#pragma once

#include <cstddef>
#include <cstdint>

namespace chesil
{

/// Cyclic redundancy check CRC-64/XZ (polynomial of ECMA-182, reflected; the one of .xz files,
/// xz-file-format 1.2.1, section 6): finds every change that lies within 64 neighbouring bits, and all others
/// but one in 2^64.
class Crc64
{
public:
    /// Takes further bytes; how they are cut into pieces does not matter.
    void add(const void* bytes, std::size_t count);

    /// Of all bytes so far.
    std::uint64_t value() const { return ~state_; }

private:
    std::uint64_t state_ = ~std::uint64_t{0};
};

} // namespace chesil
