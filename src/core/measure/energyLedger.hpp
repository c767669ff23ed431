#pragma once

namespace chesil
{

/// Where a world's energy has come from and gone to since the start [J], per unit depth in 2D. What is found now,
/// kinetic and stored in contacts, is what there was at the start plus the works less the losses; the residual is the
/// time step's error, of first order where anything is lost (losses are taken with the velocity of the half step; about
/// four times as much of it in fine steps, in which dashpots do not look ahead) and of second order without.
struct EnergyLedger
{
    /// Kinetic energy and that of contacts when the ledger began.
    double start = 0;
    /// Works on the grains; that of walls is also that of a strained cell's images.
    double gravity = 0;
    double walls = 0;
    double external = 0;
    /// Losses: dashpots, slip and rolling of contacts; the two kinds of damping.
    double contacts = 0;
    double localDamping = 0;
    double viscousDamping = 0;

    double works() const { return gravity + walls + external; }
    double losses() const { return contacts + localDamping + viscousDamping; }

    /// What there is too much now.
    double residual(double kineticEnergy, double contactEnergy) const
    {
        return kineticEnergy + contactEnergy - (start + works() - losses());
    }
};

} // namespace chesil
