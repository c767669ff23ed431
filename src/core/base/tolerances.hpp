#pragma once

#include <limits>

/// All tolerances of the engine, each relative to the size named beside it, each with its reason.
namespace chesil::tolerances
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Sizes of shapes [m] lie between these: beyond, moments of inertia (the fourth power) and curvatures run
/// out of double's range.
constexpr double leastSize = 1e-60;
constexpr double largestSize = 1e60;

/// EPA stops when its bounds on the depth differ by less than this share of the two grains' radii. Where it stops
/// is a jump in the force as the grains move; in the shallowest contact that matters, 1e-6 radii deep, this keeps the
/// jump below 1e-6 of the force, so that runs which differ by rounding (1 or 2 ranks, say) stay together.
/// The benchmark epaTolerance shows the price.
constexpr double expandingPolytope = 1e-12;

/// Rounding floor of a support difference, in units of the two grains' radii: no solver can tell
/// depths closer than this, and asking for more makes EPA blow up.
constexpr double supportRounding = 8 * epsilon;

/// Two unit normals count as one if the sine between them is below this: a few roundings of a turned normal.
constexpr double sameNormal = 4 * epsilon;

/// What a settled search leaves of its normal's angle [rad], as far as two steps tell. The depth, being flat there, is
/// settled to rounding long before; one more support call would make it 1e-16.
constexpr double settledNormal = 1e-12;

/// A contact's normal belongs to a straight side if the sine between them is below this: the solvers return a side's
/// own normal but for some roundings, and no real outline has two sides so near to parallel.
constexpr double normalOfSide = 1e-11;

/// Sides of two grains at a sine of their angle beyond this share no length, and contacts whose normals differ by more are those of
/// two sides: no polygon in use has sides so near to parallel, no flat contact that is 1 % of its length deep tilts so far with
/// both ends inside, and no normal turns so far in a step.
constexpr double oneSide = 0.05;

/// Two unit tangents at a joint may differ by this angle [rad] and still count as the same (G1).
/// Template files hold 17 digits, so that rounding leaves about 1e-15.
constexpr double joint = 1e-12;

/// A closed outline may turn inward by this angle [rad] at a vertex before it counts as not convex:
/// far below any visible dent, far above the rounding of a straight run of points.
constexpr double convexity = 1e-9;

/// The same for a mesh's cells: a hanging node on a straight side, in a mesh written with 6 digits, leaves up to
/// 1e-5 rad. The solid fraction then errs by at most that sliver of a cell.
constexpr double cellConvexity = 1e-4;

/// A boundary whose centroid lies within this share of its size from the origin is taken as centred: the
/// rounding of the moments' sum over some tens of segments.
constexpr double centroid = 1e-13;

/// A shape has a long axis if the largest and the smallest second moment of its area differ by more than this share of
/// their sum: far above the rounding of the moments, far below what could be seen as long.
constexpr double isotropic = 1e-9;

} // namespace chesil::tolerances
