#pragma once

#include "core/geometry/outline.hpp"

#include <vector>

namespace chesil
{

/// A polygon with its vertices on a convex grain's outline, hence wholly inside: tells at little cost
/// that a cell lies inside. "No" means nothing; the clip decides then.
class InscribedPolygon
{
public:
    /// Curves as in TurnedOutline, counter-clockwise, about the grain's centre [m].
    void set(const Outline& curves);

    /// True if all points [m] lie in the polygon.
    bool contains(const std::vector<Vector2>& points) const;

private:
    /// Inside is where normal . x >= offset.
    struct Edge
    {
        Vector2 normal;
        double offset;
    };

    std::vector<Edge> edges_;
    /// The disk of this radius about the centre fits in [m]; 0 if the centre lies outside.
    double innerRadius_ = 0;
};

} // namespace chesil
