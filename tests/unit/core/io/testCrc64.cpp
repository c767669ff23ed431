#include "core/io/crc64.hpp"

#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

using namespace chesil;

namespace
{

std::uint64_t sumOf(const std::string& bytes)
{
    Crc64 sum;
    sum.add(bytes.data(), bytes.size());
    return sum.value();
}

} // namespace

TEST(Crc64, hasThePublishedCheckValues)
{
    EXPECT_EQ(sumOf("123456789"), 0x995DC9BBDF1939FAu) << "CRC-64/XZ of the catalogue of parametrised CRCs";
    EXPECT_EQ(sumOf(""), 0u);
}

TEST(Crc64, doesNotDependOnThePieces)
{
    test::RandomSource random(1);
    std::string bytes;
    for (int i = 0; i < 1000; ++i)
    {
        bytes += static_cast<char>(random.integer(0, 255));
    }
    Crc64 sum;
    for (std::size_t place = 0; place < bytes.size();)
    {
        const std::size_t wanted = static_cast<std::size_t>(random.integer(0, 30));
        const std::size_t count = std::min(wanted, bytes.size() - place);
        sum.add(bytes.data() + place, count);
        place += count;
    }
    EXPECT_EQ(sum.value(), sumOf(bytes));
}
