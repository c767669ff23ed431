#pragma once

#include <algorithm>
#include <cmath>

namespace chesil
{

/// Largest stable step [s] of velocity Verlet for one grain among its like, in contacts of stiffness k [N/m].
///
/// Each contact is an element of stiffness k between two grains of mass m/Z and inertia I/Z, the grain's mass
/// being shared among its Z contacts. The largest eigenvalue of an assembly is bounded by that of its elements
/// (Irons & Treharne 1971): w^2 <= 2 Z k (1/m + R^2/I), R the longest arm. Stable: dt <= 2/w, shortened by the
/// contact's damping ratio z to (2/w)(sqrt(1 + z^2) - z), since the dashpot uses the last half step's velocity.
/// Z = 6, the most that grains of one size have in the plane; a grain with more has a larger mass, too.
inline double stableTimeStep(double mass, double inertia, double longestArm, double stiffness, double dampingRatio)
{
    constexpr double contactsOfAGrain = 6;
    const double perMass = 1 / mass + longestArm * longestArm / inertia;
    const double frequency = std::sqrt(2 * contactsOfAGrain * stiffness * perMass);
    return 2 / frequency * (std::sqrt(1 + dampingRatio * dampingRatio) - dampingRatio);
}

} // namespace chesil
