#include "core/io/crc64.hpp"

#include <array>

namespace chesil
{

namespace
{

/// tables[k][b]: the byte b, followed by k zero bytes. Eight bytes are then taken at once ("slicing-by-8",
/// Kounavis and Berry 2005).
using Tables = std::array<std::array<std::uint64_t, 256>, 8>;

constexpr Tables makeTables()
{
    constexpr std::uint64_t reflectedPolynomial = 0xC96C5795D7870F42;
    Tables tables{};
    for (std::uint64_t byte = 0; byte < 256; ++byte)
    {
        std::uint64_t rest = byte;
        for (int bit = 0; bit < 8; ++bit)
        {
            rest = (rest >> 1) ^ ((rest & 1) != 0 ? reflectedPolynomial : 0);
        }
        tables[0][byte] = rest;
    }
    for (std::size_t k = 1; k < tables.size(); ++k)
    {
        for (std::size_t byte = 0; byte < 256; ++byte)
        {
            const std::uint64_t before = tables[k - 1][byte];
            tables[k][byte] = (before >> 8) ^ tables[0][before & 0xFF];
        }
    }
    return tables;
}

constexpr Tables tables = makeTables();

} // namespace

void Crc64::add(const void* bytes, std::size_t count)
{
    const unsigned char* next = static_cast<const unsigned char*>(bytes);
    std::uint64_t state = state_;
    for (; count >= 8; count -= 8, next += 8)
    {
        std::uint64_t sum = 0;
        for (std::size_t k = 0; k < 8; ++k)
        {
            sum ^= tables[7 - k][((state >> (8 * k)) & 0xFF) ^ next[k]];
        }
        state = sum;
    }
    for (; count > 0; --count, ++next)
    {
        state = (state >> 8) ^ tables[0][(state & 0xFF) ^ *next];
    }
    state_ = state;
}

} // namespace chesil
