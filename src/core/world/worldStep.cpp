#include "core/world/world.hpp"

#include "core/dynamics/mostTravel.hpp"
#include "core/dynamics/velocityVerlet.hpp"
#include "core/measure/energy.hpp"

#include <cmath>

namespace chesil
{

StepStatus World::step(double timeStep)
{
    if (!(timeStep > 0 && std::isfinite(timeStep)))
    {
        return StepStatus::badTimeStep;
    }
    if (settings_.energyLedger && !ledger_)
    {
        ledger_.emplace();
        ledger_->start = kineticEnergy(bodies_) + contactEnergy();
    }
    if (cell_ && cell_->isStrained())
    {
        cell_->strain(timeStep);
        noteStrain();
    }
    if (walls_.anyMoves())
    {
        walls_.setVelocities(time_, timeStep);
        walls_.addWork(timeStep / 2);
        walls_.drift(timeStep);
    }
    const bool stale = cell_ ? moveGrains<true>(timeStep) : moveGrains<false>(timeStep);
    // A grain that moves by more than the skin cannot but make neighbours stale.
    if (stale && leaps(timeStep))
    {
        return StepStatus::tooFast;
    }
    if (stale && cellIsNarrow())
    {
        return StepStatus::tooNarrow;
    }
    if (ledger_)
    {
        addWorks(timeStep);
    }
    updateForces(timeStep, stale);
    const StepStatus status = finishMoves(timeStep);
    if (walls_.anyMoves())
    {
        walls_.addWork(timeStep / 2);
        if (ledger_)
        {
            ledger_->walls = walls_.work();
        }
    }
    time_ += timeStep;
    return status;
}

void World::noteStrain()
{
    strainSinceSearch_ = cell_->deformationFrom(firstAtSearch_, secondAtSearch_) - Eigen::Matrix2d::Identity();
}

/// Half a kick, then the drift; true if a grain has moved too far for its neighbours to be still all that are near.
template <bool periodic>
bool World::moveGrains(double timeStep)
{
    const double most = mostMovement();
    bool stale = positionsAtSearch_.size() != bodies_.size() || !(most > 0);
    const std::size_t known = stale ? 0 : bodies_.size();
    anticipate(timeStep);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        kick(bodies_, i, timeStep / 2);
        drift(bodies_, i, timeStep);
        stale |= i < known && hasLeft<periodic>(i, most);
    }
    return stale;
}

/// In well resolved steps the half step by which a dashpot's velocity is late does not count.
void World::anticipate(double timeStep)
{
    constexpr double counts = 0.01;
    anticipates_ = brakingRate_ * timeStep > counts;
    if (!anticipates_)
    {
        return;
    }
    expectedGains_.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        expectedGains_[i] = timeStep / 2 * bodies_.inverseMass[i] * bodies_.force[i];
    }
}

bool World::leaps(double timeStep)
{
    for (std::size_t i = 0; i < bodies_.size() && bodies_.size() > 1; ++i)
    {
        const Vector2 velocity = cell_ ? Vector2(bodies_.velocity[i] - cell_->flow(bodies_.pose[i].position)) : bodies_.velocity[i];
        const double turning = isSlender(i) ? std::abs(bodies_.angularVelocity[i]) * bodies_.boundingRadius[i] : 0;
        const double way = timeStep * (velocity.norm() + turning);
        // What is no number is told as such at the step's end.
        if (way > mostTravel(innerRadiusOf(i)) && std::isfinite(way))
        {
            brokenGrain_ = i;
            return true;
        }
    }
    return false;
}

/// The other half of the kick, and whether all went well.
StepStatus World::finishMoves(double timeStep)
{
    // Stays zero if all numbers are finite.
    double sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        kick(bodies_, i, timeStep / 2);
        sum += 0 * bodies_.velocity[i].x() + 0 * bodies_.velocity[i].y() + 0 * bodies_.angularVelocity[i];
    }
    if (tooDeep_)
    {
        return StepStatus::tooDeep;
    }
    return sum == 0 && !lost_ ? StepStatus::done : brokenState();
}

StepStatus World::brokenState()
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (!bodies_.velocity[i].allFinite() || !std::isfinite(bodies_.angularVelocity[i])
            || !bodies_.pose[i].position.allFinite())
        {
            brokenGrain_ = i;
            return StepStatus::notFinite;
        }
    }
    return StepStatus::done;
}

void World::addWorks(double timeStep)
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (bodies_.inverseMass[i] > 0)
        {
            ledger_->gravity += timeStep * weightOf(i).dot(bodies_.velocity[i]);
            if (!externalForces_.empty())
            {
                ledger_->external +=
                    timeStep * (externalForces_[i].dot(bodies_.velocity[i]) + externalTorques_[i] * bodies_.angularVelocity[i]);
            }
        }
    }
}

} // namespace chesil
