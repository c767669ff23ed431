#include "coupling/forcing/grainForcing.hpp"

namespace chesil
{

GrainForcing::GrainForcing(const World& world, const CellView& mesh, const PenaltyRate& rate)
: mesh_(mesh),
  penaltyRate_(rate),
  grains_(world.bodies().size()),
  fraction_(static_cast<std::size_t>(mesh.size()), 0.0),
  velocity_(static_cast<std::size_t>(mesh.size()), Vector2::Zero()),
  rate_(static_cast<std::size_t>(mesh.size()), 0.0)
{
    for (const NamedShape& named : world.settings().shapes)
    {
        outlines_.push_back(outline(named.shape));
    }
}

void GrainForcing::updateGeometry(const World& world)
{
    forget();
    for (std::size_t grain = 0; grain < world.bodies().size(); ++grain)
    {
        addGrain(world, grain);
    }
    // Areas and area times velocity so far; now what they are in the cell.
    for (const int cell : touched_)
    {
        const auto c = static_cast<std::size_t>(cell);
        velocity_[c] /= fraction_[c];
        fraction_[c] /= mesh_.area(cell);
    }
}

std::vector<double> GrainForcing::coveredAreas() const
{
    std::vector<double> areas(grains_, 0.0);
    for (const Share& share : shares_)
    {
        areas[share.grain] += share.area;
    }
    return areas;
}

void GrainForcing::forget()
{
    for (const int cell : touched_)
    {
        const auto c = static_cast<std::size_t>(cell);
        fraction_[c] = 0;
        velocity_[c] = Vector2::Zero();
        rate_[c] = 0;
    }
    touched_.clear();
    shares_.clear();
}

void GrainForcing::addGrain(const World& world, std::size_t grain)
{
    const Bodies<2>& bodies = world.bodies();
    cells_.update(outlines_[static_cast<std::size_t>(bodies.shape[grain])], bodies.pose[grain], mesh_);
    for (const CoveredCell& covered : cells_.cells())
    {
        const Vector2 centre = covered.firstMoment / covered.area;
        shares_.push_back({grain, covered.cell, covered.area, centre});

        const auto c = static_cast<std::size_t>(covered.cell);
        if (fraction_[c] == 0)
        {
            touched_.push_back(covered.cell);
        }
        fraction_[c] += covered.area;
        velocity_[c] += covered.area * (bodies.velocity[grain] + velocityAt(bodies.angularVelocity[grain], centre));
    }
}

} // namespace chesil
