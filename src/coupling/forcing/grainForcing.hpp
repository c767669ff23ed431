#pragma once

#include "core/world/world.hpp"
#include "coupling/cellView/cellView.hpp"
#include "coupling/forcing/penaltyRate.hpp"
#include "coupling/geometry/solidFraction.hpp"

#include <vector>

namespace chesil
{

/// Force and torque about the centroid on each grain, per unit depth [N/m], [N m/m].
struct GrainLoads
{
    std::vector<Vector2> force;
    std::vector<double> torque;

    explicit GrainLoads(std::size_t grains = 0) : force(grains, Vector2::Zero()), torque(grains, 0.0) {}
};

/// What the grains ask of the fluid's momentum equation in the cells that they touch,
///
///     source = rate (velocity - u)   [m/s2],
///
/// and what the fluid gives back to them. Knows cells as polygons, not the flow solver.
class GrainForcing
{
public:
    GrainForcing(const World& world, const CellView& mesh, const PenaltyRate& rate);

    /// Finds covered cells, solid fractions and velocities for the grains as they are.
    void updateGeometry(const World& world);

    /// Sets the rates from the fluid as it is. fluidVelocity(cell) gives u [m/s], viscosity(cell) nu [m2/s].
    template <class FluidVelocity, class Viscosity>
    void updateRates(const FluidVelocity& fluidVelocity, const Viscosity& viscosity)
    {
        for (const int cell : touched_)
        {
            const auto c = static_cast<std::size_t>(cell);
            const double speed = (fluidVelocity(cell) - velocity_[c]).norm();
            rate_[c] = penaltyRate_(fraction_[c], viscosity(cell), mesh_.width(cell), speed);
        }
    }

    /// Cells that a grain covers or cuts, in no particular order.
    const std::vector<int>& touched() const { return touched_; }

    /// Share of the cell covered by grains; the sum over grains, which passes 1 where they overlap.
    double fraction(int cell) const { return fraction_[static_cast<std::size_t>(cell)]; }

    /// Velocity of the covered part, averaged over it [m/s].
    const Vector2& velocity(int cell) const { return velocity_[static_cast<std::size_t>(cell)]; }

    /// [1/s].
    double rate(int cell) const { return rate_[static_cast<std::size_t>(cell)]; }

    /// Area of each grain that lies in cells of this mesh [m2].
    std::vector<double> coveredAreas() const;

    /// What the forcing does to the grains: its opposite, over the cells of this mesh, for fluid density
    /// [kg/m3]. Grains in one cell share its force by their areas: each against its own velocity would be a
    /// dashpot between them, as stiff as the rate, and explicit in time. The inertia of the fluid inside the grains is not in it (GrainResponse adds it).
    template <class FluidVelocity>
    void addLoads(const FluidVelocity& fluidVelocity, double fluidDensity, GrainLoads& loads) const
    {
        for (const Share& share : shares_)
        {
            const auto c = static_cast<std::size_t>(share.cell);
            const double weight = share.area / (fraction_[c] * mesh_.area(share.cell));
            const Vector2 force = fluidDensity * weight * rate_[c] * mesh_.area(share.cell)
                * (fluidVelocity(share.cell) - velocity_[c]);
            loads.force[share.grain] += force;
            loads.torque[share.grain] += cross(share.centre, force);
        }
    }

private:
    /// One grain's part of one cell.
    struct Share
    {
        std::size_t grain;
        int cell;
        double area;
        /// Centroid of the covered part relative to the grain's [m].
        Vector2 centre;
    };

    void forget();
    void addGrain(const World& world, std::size_t grain);

    const CellView& mesh_;
    PenaltyRate penaltyRate_;
    std::size_t grains_;
    std::vector<Outline> outlines_;
    GrainCells cells_;
    std::vector<Share> shares_;
    std::vector<int> touched_;
    // One entry a cell of the mesh, 0 where no grain is; only touched ones are ever visited.
    std::vector<double> fraction_;
    std::vector<Vector2> velocity_;
    std::vector<double> rate_;
};

} // namespace chesil
