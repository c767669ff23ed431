#pragma once

#include "core/base/tolerances.hpp"
#include "core/base/vector.hpp"

namespace chesil
{

/// A contact's depth [m] and unit normal, from the first body to the second.
template <int Dim>
struct SideHeld
{
    double depth;
    Vector<Dim> normal;
};

/// Whether two contacts of a pair, a step apart, are those of different sides.
template <int Dim>
bool areOfTwoSides(const SideHeld<Dim>& before, const SideHeld<Dim>& now)
{
    return before.depth > 0 && now.depth > 0
        && (now.normal - before.normal).squaredNorm() > tolerances::oneSide * tolerances::oneSide;
}

/// What to add to the force on the first body in a step in which the side of least depth changed from that of
/// `before`, at the step's beginning, to that of `now`, at its end [N]; zero if it was not the depth that told them apart. `velocity`: of the first body against the second at the contact point, in the
/// middle of the step [m/s]. `push`: repulsion now [N].
///
/// The force found at the end stands for half a step before, too, though the other side may have held for less or more of it:
/// for the share s of the step after which both depths, going on at this velocity, are equal. With (s - 1/2) of the difference
/// of the two forces added, each change of side errs by the step's square instead of the step. doc/timeStep.md.
template <int Dim>
Vector<Dim> sideChange(
    const SideHeld<Dim>& before, const SideHeld<Dim>& now, const Vector<Dim>& velocity, double push, double timeStep)
{
    const double aheadAtStart = now.depth - timeStep * velocity.dot(now.normal) - before.depth;
    const double aheadAtEnd = now.depth - before.depth - timeStep * velocity.dot(before.normal);
    if (!(aheadAtStart >= 0 && aheadAtEnd <= 0 && aheadAtStart > aheadAtEnd))
    {
        return Vector<Dim>::Zero();
    }
    const double share = aheadAtStart / (aheadAtStart - aheadAtEnd);
    return (share - 0.5) * push * (now.normal - before.normal);
}

} // namespace chesil
