#pragma once

#include "core/measure/measuredContact.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace chesil
{

/// Contacts whose normals lie within one bin of directions.
struct PolarBin
{
    std::size_t contacts = 0;
    /// Share of all normals per angle [1/rad], to be compared with E(t) of `DirectionalAverages`: every
    /// contact counts for its normal and for the opposite one, so that the integral over the full turn is 1.
    /// 0 without contacts.
    double density = 0;
    /// Means over the bin's contacts [N], signs as `normalForce` and `tangentialForce`; nothing in an empty
    /// bin.
    std::optional<double> normalForce;
    std::optional<double> tangentialForce;
};

/// Contact normals and mean forces by direction, in `bins` equal bins of [0, pi), bin k centred on k pi/bins
/// as in `roseHistogram`; the other half turn is the same. Counts contact points. Throws ValueError on no
/// bins.
std::vector<PolarBin> polarHistogram(const std::vector<Contact<2>>& contacts, std::size_t bins,
                                     WallContacts walls);

} // namespace chesil
