#include "core/measure/coordination.hpp"

#include "core/base/setupError.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

namespace chesil
{

namespace
{

using Pair = std::pair<std::int32_t, std::int32_t>;

/// Each pair of touching bodies once; a wall is negative and stands first.
std::vector<Pair> touchingPairs(const std::vector<Contact<2>>& contacts, std::size_t numberOfGrains,
                                WallContacts walls)
{
    std::vector<Pair> pairs;
    for (const Contact<2>& contact : contacts)
    {
        if (!isMeasured(contact, walls))
        {
            continue;
        }
        const Pair pair = std::minmax(contact.first, contact.second);
        if (contact.first < 0 || static_cast<std::size_t>(pair.second) >= numberOfGrains)
        {
            throw ValueError("a contact of grains " + std::to_string(contact.first) + " and " +
                                 std::to_string(contact.second),
                             "numbers below " + std::to_string(numberOfGrains));
        }
        pairs.push_back(pair);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

std::vector<std::size_t> neighbourCounts(const std::vector<Pair>& pairs, std::size_t numberOfGrains)
{
    std::vector<std::size_t> counts(numberOfGrains, 0);
    for (const auto& [low, high] : pairs)
    {
        ++counts[high];
        if (low >= 0)
        {
            ++counts[low];
        }
    }
    return counts;
}

/// The grains that each grain touches, those of one grain in a row.
struct Adjacency
{
    /// Grain i's are from start[i] up to start[i + 1].
    std::vector<std::size_t> start;
    std::vector<std::int32_t> grains;
};

Adjacency adjacencyOf(const std::vector<Pair>& pairs, std::size_t numberOfGrains)
{
    Adjacency adjacency;
    adjacency.start.assign(numberOfGrains + 1, 0);
    for (const auto& [low, high] : pairs)
    {
        if (low >= 0)
        {
            ++adjacency.start[low + 1];
            ++adjacency.start[high + 1];
        }
    }
    std::partial_sum(adjacency.start.begin(), adjacency.start.end(), adjacency.start.begin());
    adjacency.grains.resize(adjacency.start.back());
    std::vector<std::size_t> next(adjacency.start);
    for (const auto& [low, high] : pairs)
    {
        if (low >= 0)
        {
            adjacency.grains[next[low]++] = high;
            adjacency.grains[next[high]++] = low;
        }
    }
    return adjacency;
}

/// Takes rattlers away, one after the other; `counts` are then the neighbours among those left.
std::vector<bool> findRattlers(const Adjacency& adjacency, std::size_t least,
                               std::vector<std::size_t>& counts)
{
    std::vector<bool> rattles(counts.size(), false);
    std::vector<std::size_t> removed;
    const auto removeIfLoose = [&](std::size_t grain)
    {
        if (!rattles[grain] && counts[grain] < least)
        {
            rattles[grain] = true;
            removed.push_back(grain);
        }
    };
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
        removeIfLoose(i);
        while (!removed.empty())
        {
            const std::size_t gone = removed.back();
            removed.pop_back();
            for (std::size_t k = adjacency.start[gone]; k < adjacency.start[gone + 1]; ++k)
            {
                --counts[adjacency.grains[k]];
                removeIfLoose(adjacency.grains[k]);
            }
        }
    }
    return rattles;
}

} // namespace

Coordination coordination(const std::vector<Contact<2>>& contacts, std::size_t numberOfGrains,
                          std::size_t leastNeighbours, WallContacts walls)
{
    const std::vector<Pair> pairs = touchingPairs(contacts, numberOfGrains, walls);
    Coordination result;
    if (numberOfGrains == 0)
    {
        return result;
    }
    std::vector<std::size_t> counts = neighbourCounts(pairs, numberOfGrains);
    const double grains = static_cast<double>(numberOfGrains);

    result.histogram.assign(*std::max_element(counts.begin(), counts.end()) + 1, 0);
    for (const std::size_t count : counts)
    {
        ++result.histogram[count];
    }
    result.mean = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0})) / grains;

    result.rattles = findRattlers(adjacencyOf(pairs, numberOfGrains), leastNeighbours, counts);
    std::size_t neighboursLeft = 0;
    for (std::size_t i = 0; i < numberOfGrains; ++i)
    {
        result.rattlers += result.rattles[i] ? 1 : 0;
        neighboursLeft += result.rattles[i] ? 0 : counts[i];
    }
    result.rattlerShare = static_cast<double>(result.rattlers) / grains;
    if (result.rattlers < numberOfGrains)
    {
        result.meanWithoutRattlers =
            static_cast<double>(neighboursLeft) / static_cast<double>(numberOfGrains - result.rattlers);
    }
    return result;
}

} // namespace chesil
