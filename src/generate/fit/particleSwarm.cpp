#include "generate/fit/particleSwarm.hpp"

#include <limits>
#include <random>
#include <vector>

namespace chesil
{

namespace
{

constexpr double constriction = 0.7298;
constexpr double attraction = 2.05;

struct Particle
{
    Eigen::ArrayXd place;
    Eigen::ArrayXd velocity;
    Eigen::ArrayXd bestPlace;
    double best = std::numeric_limits<double>::infinity();
};

/// Numbers in [0, 1) that are the same with every standard library.
class Uniform
{
public:
    explicit Uniform(std::uint64_t seed) : engine_(seed) {}

    Eigen::ArrayXd operator()(Eigen::Index count)
    {
        Eigen::ArrayXd numbers(count);
        for (double& number : numbers)
        {
            number = static_cast<double>(engine_() >> 11) * 0x1p-53;
        }
        return numbers;
    }

private:
    std::mt19937_64 engine_;
};

} // namespace

Eigen::ArrayXd minimiseBySwarm(const std::function<double(const Eigen::ArrayXd&)>& cost,
                               const Eigen::ArrayXd& lower, const Eigen::ArrayXd& upper,
                               const SwarmSettings& settings)
{
    Uniform uniform(settings.seed);
    std::vector<Particle> swarm(static_cast<std::size_t>(settings.particles));
    for (Particle& particle : swarm)
    {
        particle.place = lower + uniform(lower.size()) * (upper - lower);
        particle.velocity = Eigen::ArrayXd::Zero(lower.size());
    }
    Particle leader;
    for (int iteration = 0; iteration <= settings.iterations; ++iteration)
    {
        for (Particle& particle : swarm)
        {
            const double here = cost(particle.place);
            if (here < particle.best)
            {
                particle.best = here;
                particle.bestPlace = particle.place;
            }
            if (here < leader.best)
            {
                leader = particle;
            }
        }
        for (Particle& particle : swarm)
        {
            particle.velocity += attraction * uniform(lower.size()) * (particle.bestPlace - particle.place);
            particle.velocity += attraction * uniform(lower.size()) * (leader.bestPlace - particle.place);
            particle.velocity *= constriction;
            const Eigen::ArrayXd wanted = particle.place + particle.velocity;
            particle.place = wanted.max(lower).min(upper);
            particle.velocity = (particle.place == wanted).select(particle.velocity, 0.0);
        }
    }
    return leader.bestPlace;
}

} // namespace chesil
