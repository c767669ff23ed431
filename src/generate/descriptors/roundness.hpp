#pragma once

#include "generate/descriptors/closedOutline.hpp"

namespace chesil
{

/// Wadell's roundness (1932): mean radius of the corners over that of the inscribed circle, `inscribedRadius`. Corners are the stretches
/// that are curved more than it, each counted by the angle that it turns (a stretch's mean radius is its length over its
/// angle); around the inscribed circle's curvature a stretch counts more and more, so that no corner comes or goes at a blow.
/// 0 for a polygon, 1 if there is no corner. An outline from pixels is to be smoothed before; sides longer
/// than `straight` are straight, shorter ones chords of a curve.
double cornerRoundness(const ClosedOutline& outline, double inscribedRadius, double straight);

/// Mollon & Zhao's roundness (2012, eq. 2): mean radius of circles that cover the whole outline over that of the inscribed
/// circle. At each point the largest circle is drawn that touches there from inside, which covers the outline on both sides as
/// long as that is within 2 % of the inscribed radius from it. A circle counts by one over the length that it covers: that is the mean over
/// all coverings by circles side by side, where a single one would depend on which circle comes first.
double coverRoundness(const ClosedOutline& outline, double inscribedRadius);

} // namespace chesil
