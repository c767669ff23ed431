#pragma once

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace chesil
{

/// Source of all random bits of a set-up: the standard fixes every one of them.
using RandomEngine = std::mt19937_64;

/// Uniform on [0, 1), the same bits with every standard library (std::uniform_real_distribution is not): the
/// upper 53 bits of the next number times 2^-53.
inline double uniform(RandomEngine& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

/// One of 0, ..., size - 1; size >= 1 and far below 2^53.
inline std::size_t randomIndex(RandomEngine& engine, std::size_t size)
{
    return static_cast<std::size_t>(uniform(engine) * static_cast<double>(size));
}

/// Any order with equal chance (Fisher and Yates; std::shuffle differs between libraries).
template <class Type>
void shuffle(std::vector<Type>& items, RandomEngine& engine)
{
    for (std::size_t left = items.size(); left > 1; --left)
    {
        std::swap(items[left - 1], items[randomIndex(engine, left)]);
    }
}

} // namespace chesil
