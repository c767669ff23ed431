#pragma once

#include "core/base/supportContract.hpp"
#include "core/base/vector.hpp"
#include "core/geometry/cubicBezier.hpp"
#include "core/geometry/outline.hpp"
#include "core/shapes/massProperties.hpp"
#include "core/shapes/normalTable.hpp"

#include <algorithm>
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
        const CubicBezier& curve = curves_[normals_.find(direction)];
        return curve.at(curve.supportParameter(direction));
    }

    double boundingRadius() const { return boundingRadius_; }

    CurvedPoint<2> curvedSupport(const Vector2& normal) const
    {
        const std::size_t piece = normals_.find(normal);
        CurvedPoint<2> result = curves_[piece].curvedSupport(normal);
        if (result.radius.value == 0)
        {
            result.room = roomAtCorner(piece, normal);
        }
        return result;
    }

    /// The same of two grains at once, each along a unit normal (x[0], y[0]), (x[1], y[1]) in its own frame.
    static CurvedCoordinates<TwoLanes> curvedSupports(const PolyBezier& a, const PolyBezier& b, const TwoLanes& x, const TwoLanes& y)
    {
        const Vector2 normalA(x[0], y[0]);
        const Vector2 normalB(x[1], y[1]);
        const std::size_t pieceA = a.normals_.find(normalA);
        const std::size_t pieceB = b.normals_.find(normalB);
        CurvedCoordinates<TwoLanes> result = chesil::curvedSupports(a.curves_[pieceA], b.curves_[pieceB], x, y);
        if (!areAll(result.radius != 0))
        {
            const TwoLanes rooms{a.roomAtCorner(pieceA, normalA), b.roomAtCorner(pieceB, normalB)};
            result.room = result.radius == 0 ? rooms : result.room;
        }
        return result;
    }

    OutlineStretch stretchAt(const Vector2& normal) const { return stretches_[normals_.find(normal)]; }
    double leastRadiusBetween(const Vector2& first, const Vector2& last) const;
    double leastRadius() const { return leastRadius_; }
    double innerRadius() const { return innerRadius_; }
    static constexpr bool mayHaveStraightSides = true;
    bool hasStraightSides() const { return !straightSides_.empty(); }
    const StraightSide* straightSideFacing(const Vector2& normal) const;
    const StraightSide* straightSideBetween(const Vector2& from, const Vector2& to) const;

    MassProperties massProperties() const { return mass_; }
    Outline outline() const { return Outline(segments_.begin(), segments_.end()); }

private:
    double roomAtCorner(std::size_t piece, const Vector2& normal) const
    {
        const OutlineStretch& corner = stretches_[piece];
        return std::max(0.0, std::min(cross(corner.firstNormal, normal), cross(normal, corner.lastNormal)));
    }

    std::vector<CubicBezier> segments_;
    Vector2 givenCentroid_ = Vector2::Zero();
    /// The segments and, as curves of no length, the corners between them.
    std::vector<CubicBezier> curves_;
    std::vector<OutlineStretch> stretches_;
    NormalTable normals_;
    /// Least radius of curvature of each part of the curves, for bounds that are nearly tight.
    std::vector<double> partRadii_;
    NormalTable partNormals_;
    std::vector<StraightSide> straightSides_;
    double leastRadius_ = 0;
    double innerRadius_ = 0;
    double boundingRadius_ = 0;
    MassProperties mass_;
};

} // namespace chesil
