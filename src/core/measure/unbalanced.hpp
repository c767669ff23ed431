#pragma once

#include "core/contact/contact.hpp"

#include <optional>
#include <vector>

namespace chesil
{

/// How far a sample is from rest: resultant force on a grain over the mean contact force.
struct UnbalancedForce
{
    double largest = 0;
    /// Mean over the grains that move.
    double mean = 0;
};

/// `force` is the resultant on each grain [N], with weight and fluid, before numerical damping (`dampLocally`
/// changes `Bodies::force` in place); grains with inverse mass 0 are left out. The mean contact force is that
/// of the magnitudes over all contact points, walls included; a flat contact's two ends are two. Nothing if
/// no grain moves or there is no contact force to compare with. Throws ValueError if the two arrays differ in
/// length.
std::optional<UnbalancedForce> unbalancedForce(const std::vector<Vector2>& force,
                                               const std::vector<double>& inverseMass,
                                               const std::vector<Contact<2>>& contacts);

} // namespace chesil
