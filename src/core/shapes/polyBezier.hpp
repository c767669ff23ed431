#pragma once

#include "core/base/vector.hpp"
#include "core/geometry/cubicBezier.hpp"
#include "core/geometry/outline.hpp"
#include "core/shapes/massProperties.hpp"
#include "core/shapes/normalTable.hpp"

#include <vector>

namespace chesil
{

/// A convex grain bounded by cubic Bezier segments, joined end to start, counter-clockwise, with one
/// tangent at each smooth joint (G1) or an outward corner. Source: Lai & Huang, section 2.
///
/// The segments [m] are given in any frame and kept about the centroid. Throws ValueError if they do not
/// close, if the polygon of all control points is not convex, or if a segment turns by more than 180 degrees.
/// That polygon being convex makes the curve convex, and every outline built after section 2.1 of the paper
/// satisfies it.
class PolyBezier
{
public:
    static constexpr const char* typeName = "polybezier";

    explicit PolyBezier(const std::vector<CubicBezier>& segments);

    /// Counter-clockwise, about the centroid [m].
    const std::vector<CubicBezier>& segments() const { return segments_; }

    /// The centroid in the frame of the segments given to the constructor [m].
    const Vector2& givenCentroid() const { return givenCentroid_; }

    /// Largest angle between the tangents on both sides of a joint [rad]; at most tolerances::joint if
    /// the outline is smooth (G1).
    double largestJointAngle() const;

    Vector2 support(const Vector2& direction) const
    {
        const CubicBezier& segment = segments_[normals_.find(direction)];
        return segment.at(segment.supportParameter(direction));
    }

    double boundingRadius() const { return boundingRadius_; }

    MassProperties massProperties() const { return mass_; }
    Outline outline() const { return Outline(segments_.begin(), segments_.end()); }

private:
    std::vector<CubicBezier> segments_;
    Vector2 givenCentroid_ = Vector2::Zero();
    NormalTable normals_;
    double boundingRadius_ = 0;
    MassProperties mass_;
};

} // namespace chesil
