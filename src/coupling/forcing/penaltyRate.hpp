#pragma once

#include <algorithm>

namespace chesil
{

/// How hard the fluid in a cell is held to the grains' velocity [1/s].
///
/// A cell with solid fraction f is coupled at the rate c f/(1 - f) (nu/w^2 + |u|/w): the rate of viscous and
/// convective exchange over the cell's width w [m], at kinematic viscosity nu [m2/s] and speed |u| [m/s] of the
/// fluid relative to the grain, divided by the share of the cell that is left to the fluid. It does not depend
/// on the time step. In a cell that is all solid the fraction of fluid is taken as `leftOver`, which makes the
/// rate so high that the fluid there moves as the grain does. doc/coupling.md derives the form and shows what
/// the constants do to the drag.
struct PenaltyRate
{
    double coefficient = 8;
    double leftOver = 1e-4;

    double operator()(double solidFraction, double viscosity, double width, double speed) const
    {
        const double solid = std::min(solidFraction, 1.0);
        const double exchange = viscosity / (width * width) + speed / width;
        return coefficient * exchange * solid / (1 - solid + leftOver);
    }
};

} // namespace chesil
