#include "core/world/world.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

namespace
{

/// Of the upright box about the centroid [m].
Vector2 halfExtentOf(const Shape& shape, const Rotation<2>& rotation)
{
    Vector2 half;
    for (int k = 0; k < 2; ++k)
    {
        const Vector2 direction = rotation.applyInverse(Vector2::Unit(k));
        half[k] = std::max(support(shape, direction).dot(direction), support(shape, -direction).dot(-direction));
    }
    return half;
}

} // namespace

/// Of a grain since the last search, on top of the cell's strain, so that no pair that was farther apart than the skin
/// can touch [m]. Images at the reach of the widest pair come nearer by the strain itself.
double World::mostMovement() const
{
    double most = skin_ / 2;
    if (walls_.anyMoves() && !(walls_.movedSinceSearch() <= most))
    {
        return 0;
    }
    if (cell_)
    {
        most -= strainSinceSearch_.norm() * largestReach_ / 2;
    }
    return most;
}

bool World::neighboursAreStale() const
{
    const double most = mostMovement();
    if (positionsAtSearch_.size() != bodies_.size() || !(most > 0))
    {
        return true;
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        if (cell_ ? hasLeft<true>(i, most) : hasLeft<false>(i, most))
        {
            return true;
        }
    }
    return false;
}

void World::findNeighbours()
{
    if (cell_)
    {
        wrapGrains();
        firstAtSearch_ = cell_->cell.first();
        secondAtSearch_ = cell_->cell.second();
        strainSinceSearch_.setZero();
    }
    positionsAtSearch_.resize(bodies_.size());
    std::transform(
        bodies_.pose.begin(), bodies_.pose.end(), positionsAtSearch_.begin(), [](const Pose<2>& p) { return p.position; });
    walls_.noteSearch();
    noteBoxes();
    findContacts();
    lost_ = brokenState() != StepStatus::done;
}

/// As wrapGrains() is about to make it.
bool World::cellIsNarrow() const
{
    if (!cell_ || bodies_.size() == 0)
    {
        return false;
    }
    // The search adds up the same reach in another order.
    constexpr double roundingSlack = 1 + 1e-12;
    StrainedCell upright = *cell_;
    upright.straighten();
    return !(upright.cell.widths().minCoeff() > 2 * largestReach_ * roundingSlack);
}

/// Grains that have left the cell come in from the other side, with the flow's velocity there; the ledger counts the
/// difference as work of the boundary.
void World::wrapGrains()
{
    cell_->straighten();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        const Shift shift = cell_->cell.wrap(bodies_.pose[i].position);
        if (shift == Shift{})
        {
            continue;
        }
        const Vector2 jump = cell_->velocityGradient * cell_->cell.offset(shift);
        if (ledger_ && bodies_.inverseMass[i] > 0)
        {
            ledger_->walls += jump.dot(bodies_.velocity[i] + jump / 2) / bodies_.inverseMass[i];
        }
        bodies_.velocity[i] += jump;
    }
}

void World::noteBoxes()
{
    std::size_t grain = 0;
    while (grain < bodies_.size() && !isSlender(grain))
    {
        ++grain;
    }
    if (grain == bodies_.size())
    {
        return;
    }
    halfExtents_.resize(bodies_.size());
    anglesAtSearch_.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        const double radius = bodies_.boundingRadius[i];
        halfExtents_[i] = isSlender(i) ? halfExtentOf(shapeOf(i), bodies_.pose[i].rotation) : Vector2(radius, radius);
        anglesAtSearch_[i] = bodies_.pose[i].rotation.angle();
    }
}

void World::findContacts()
{
    const std::vector<double>& radii = bodies_.boundingRadius;
    std::vector<PairKey>& pairs = cell_ ? search_.find(positionsAtSearch_, halfExtents_, radii, skin_, cell_->cell)
                                        : search_.find(positionsAtSearch_, halfExtents_, radii, skin_);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        for (std::size_t w = walls().size(); w-- > 0;)
        {
            if (nearestTo(walls()[w], positionsAtSearch_[i]) <= radii[i] + walls_.halfThickness(w) + skin_)
            {
                pairs.push_back({static_cast<std::int32_t>(i), PairKey::wallAsSecond(w)});
            }
        }
    }
    if (std::find(straightSided_.begin(), straightSided_.end(), true) != straightSided_.end())
    {
        list_.renew(withBothPlaces(pairs));
    }
    else
    {
        list_.renew(pairs);
    }
}

/// Pairs with straight sides on both may touch at two places.
std::vector<PairKey> World::withBothPlaces(const std::vector<PairKey>& pairs) const
{
    std::vector<PairKey> places;
    places.reserve(2 * pairs.size());
    for (const PairKey& pair : pairs)
    {
        places.push_back(pair);
        if (isStraightSided(static_cast<std::size_t>(pair.first))
            && (pair.withWall() || isStraightSided(static_cast<std::size_t>(pair.second))))
        {
            places.push_back(pair);
            places.back().place = 1;
        }
    }
    return places;
}

} // namespace chesil
