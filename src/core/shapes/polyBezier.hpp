#pragma once

#include "core/base/supportContract.hpp"
#include "core/base/vector.hpp"
#include "core/geometry/cubicBezier.hpp"
#include "core/geometry/outline.hpp"
#include "core/shapes/massProperties.hpp"
#include "core/shapes/normalTable.hpp"

#include <array>
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

    /// The same of two grains at once, each along a unit normal (x[0], y[0]), (x[1], y[1]) in its own frame. `guess`: the
    /// pieces looked at first, and on return the right ones.
    static CurvedCoordinates<TwoLanes> curvedSupports(
        const PolyBezier& a, const PolyBezier& b, const TwoLanes& x, const TwoLanes& y, PieceGuess& guess)
    {
        if (guess.onA < a.curves_.size() && guess.onB < b.curves_.size())
        {
            const auto segments = sideBySide(a.curves_[guess.onA], b.curves_[guess.onB], x, y);
            if (segments.isWithin())
            {
                const auto& rise = segments.rise;
                return curvedSupportAt(segments, supportRootWithin(rise[0], rise[1], rise[2]));
            }
        }
        return searchedCurvedSupports(a, b, x, y, guess);
    }

    double leastRadiusBetween(const Vector2& first, const Vector2& last) const;
    std::size_t partAt(const Vector2& normal) const { return partNormals_.find(normal); }
    std::size_t partAfter(std::size_t part) const { return part + 1 < partRadii_.size() ? part + 1 : 0; }
    std::size_t partBefore(std::size_t part) const { return (part > 0 ? part : partRadii_.size()) - 1; }
    const Vector2& partStart(std::size_t part) const { return partStarts_[part]; }
    double partRadius(std::size_t part) const { return partRadii_[part]; }
    double leastRadius() const { return leastRadius_; }
    double innerRadius() const { return innerRadius_; }
    static constexpr bool mayHaveStraightSides = true;
    bool hasStraightSides() const { return !straightSides_.empty(); }
    const StraightSide* straightSideFacing(const Vector2& normal) const;
    const StraightSide* straightSideBetween(const Vector2& from, const Vector2& to) const;

    MassProperties massProperties() const { return mass_; }
    Outline outline() const { return Outline(segments_.begin(), segments_.end()); }

private:
    static CurvedCoordinates<TwoLanes> searchedCurvedSupports(
        const PolyBezier& a, const PolyBezier& b, const TwoLanes& x, const TwoLanes& y, PieceGuess& guess);

    double roomAtCorner(std::size_t piece, const Vector2& normal) const;

    std::vector<CubicBezier> segments_;
    Vector2 givenCentroid_ = Vector2::Zero();
    /// The segments and, as curves of no length, the corners between them.
    std::vector<CubicBezier> curves_;
    /// First and last normal of each.
    std::vector<std::array<Vector2, 2>> ranges_;
    NormalTable normals_;
    /// Least radius of curvature of each part of the curves, for bounds that are nearly tight.
    std::vector<double> partRadii_;
    std::vector<Vector2> partStarts_;
    NormalTable partNormals_;
    std::vector<StraightSide> straightSides_;
    double leastRadius_ = 0;
    double innerRadius_ = 0;
    double boundingRadius_ = 0;
    MassProperties mass_;
};

} // namespace chesil
