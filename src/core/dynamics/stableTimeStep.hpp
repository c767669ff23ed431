#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

/// Largest stable step [s] of velocity Verlet for grains in contacts of stiffness k [N/m] and damping ratio z.
///
/// Each contact is an element between two grains that each give it 1/Z of their mass m and inertia I, being shared
/// among Z contacts. The largest eigenvalue of an assembly is bounded by that of its elements (Irons & Treharne
/// 1971): w^2 <= 2 k max(Z g/m), where g = 1 + m R^2/I and R is the longest arm. Z = 6, the most neighbours that grains
/// of one size have in the plane, times the places of a contact (2 for straight sides); a grain with more has a
/// larger mass, too.
///
/// Undamped: dt <= 2/w. The dashpots, c = 2 z sqrt(k m12) with the pair's effective mass m12, see the last half
/// step's velocity, which asks for w^2 dt^2 + 4 x w dt <= 4: dt <= (2/w)(sqrt(1 + x^2) - x). Their share of critical
/// damping in that mode, x, is z of an element's full mass but more of a Z-th of it: x^2 <= z^2 Z max(g). Local
/// damping raises a force that brakes by the factor 1 + share, as every force does in the mode that oscillates from
/// step to step: w and x grow with its root.
class StableTimeStep
{
public:
    /// A grain that moves: mass [kg], moment of inertia [kg m2], longest arm of a contact [m], places at which it
    /// touches a neighbour, largest stiffness of its contacts [N/m]. The spring of rolling resistance, k c R^2, adds
    /// its share c.
    void add(double mass, double inertia, double longestArm, double stiffness, int places = 1, double rollingShare = 0)
    {
        const double spread = places * (1 + mass * longestArm * longestArm * (1 + rollingShare) / inertia);
        largestSpread_ = std::max(largestSpread_, spread);
        largestMobility_ = std::max(largestMobility_, stiffness * spread / mass);
    }

    /// Infinite without grains.
    double of(double dampingRatio, double localDamping) const
    {
        if (largestMobility_ == 0)
        {
            return std::numeric_limits<double>::infinity();
        }
        constexpr double contactsOfAGrain = 6;
        const double raised = 1 + localDamping;
        const double frequency = std::sqrt(2 * raised * contactsOfAGrain * largestMobility_);
        const double share = dampingRatio * std::sqrt(raised * contactsOfAGrain * largestSpread_);
        return 2 / (frequency * (std::sqrt(1 + share * share) + share));
    }

private:
    double largestSpread_ = 0;
    /// Stiffness times spread over mass [1/s2].
    double largestMobility_ = 0;
};

} // namespace chesil
