#pragma once

#include "core/measure/measuredContact.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace chesil
{

/// How many neighbours grains have. A neighbour is a body touched, at however many places: both ends of a
/// flat contact are one neighbour, and so are two images of one grain in a periodic cell. Each wall is a
/// neighbour of its own.
struct Coordination
{
    /// Neighbours of a grain, mean over all grains; nothing without grains.
    std::optional<double> mean;
    /// The same of the grains left without rattlers, which are neighbours to none; nothing if all rattle.
    std::optional<double> meanWithoutRattlers;
    /// Grains that rattle, and their share of all; nothing without grains.
    std::size_t rattlers = 0;
    std::optional<double> rattlerShare;
    /// Entry i: whether grain i rattles.
    std::vector<bool> rattles;
    /// Entry k: grains with k neighbours, rattlers included; as long as the largest k needs, empty without
    /// grains.
    std::vector<std::size_t> histogram;
};

/// Rattlers are the grains with fewer than `leastNeighbours` (2 with friction, 3 without), then those that
/// have too few once these are gone, and so on: what stays is the k-core of the contact graph, whatever the
/// order. `walls` holds for means, histogram and rattlers alike. Throws ValueError on a contact of a grain
/// beyond `numberOfGrains`.
Coordination coordination(const std::vector<Contact<2>>& contacts, std::size_t numberOfGrains,
                          std::size_t leastNeighbours, WallContacts walls);

} // namespace chesil
