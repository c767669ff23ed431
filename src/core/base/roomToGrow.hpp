#pragma once

#include <cstddef>
#include <vector>

namespace chesil
{

/// Makes room for so many entries and a quarter more, if they do not fit yet. Memory that is not touched costs nothing,
/// while a big buffer that is outgrown leaves a hole, and doubling shows in the memory of big scenes.
template <class Entry>
void makeRoom(std::vector<Entry>& buffer, std::size_t entries)
{
    if (entries > buffer.capacity())
    {
        buffer.reserve(entries + entries / 4);
    }
}

} // namespace chesil
