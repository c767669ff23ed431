#pragma once

#include <Eigen/Dense>

#include <cstdint>
#include <functional>

namespace chesil
{

/// Particle swarm with constriction (Clerc & Kennedy 2002: chi = 0.7298, c1 = c2 = 2.05), each particle drawn
/// to its own and the whole swarm's best place. Lai & Huang name no numbers; 20 to 50 particles are common
/// after Poli, Kennedy & Blackwell 2007, whom they cite.
struct SwarmSettings
{
    int particles = 20;
    int iterations = 50;
    /// The same seed gives the same bits.
    std::uint64_t seed = 1;
};

/// The best place found of `cost` in the box between `lower` and `upper`. Particles start at random places at
/// rest; one that would leave the box stops at its side.
Eigen::ArrayXd minimiseBySwarm(const std::function<double(const Eigen::ArrayXd&)>& cost,
                               const Eigen::ArrayXd& lower, const Eigen::ArrayXd& upper,
                               const SwarmSettings& settings = {});

} // namespace chesil
