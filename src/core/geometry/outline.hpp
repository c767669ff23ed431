#pragma once

#include "core/base/pose.hpp"
#include "core/geometry/cubicBezier.hpp"
#include "core/geometry/ellipticArc.hpp"

#include <variant>
#include <vector>

namespace chesil
{

/// One piece of a grain's boundary, exact: a straight line is a cubic segment too.
using OutlinePiece = std::variant<CubicBezier, EllipticArc>;

/// A closed counter-clockwise chain of pieces.
using Outline = std::vector<OutlinePiece>;

/// The outline in the world's frame, of one given in the grain's.
Outline placed(const Outline& outline, const Pose<2>& pose);

/// Points along the outline [m], counter-clockwise, the first not repeated. Each curved piece gives
/// enough of them that the chords leave it by at most `tolerance` [m].
std::vector<Vector2> outlinePoints(const Outline& outline, double tolerance);

} // namespace chesil
