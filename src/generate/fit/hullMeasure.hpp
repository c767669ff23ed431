#pragma once

#include "generate/fit/hullCorners.hpp"

namespace chesil
{

/// How many segments each stretch of a convex polygon needs: a measure along it that is spread evenly over
/// the segments. It is the affine arc length, the integral of ds^(2/3) dtheta^(1/3) over length s and turn
/// theta: cubic segments (nearly) keep their shape under affine maps, so that a slender ellipse needs no more
/// of them than a circle. A tenth of length and turn is added, so that no stretch is without measure. Length
/// and turn are smoothed over a share of a segment, since a polygon has one of them at a time.
class HullMeasure
{
public:
    /// `segments`: that the whole outline is to have, for the smoothing. The polygon is cut at the corners;
    /// without any it starts at its first edge.
    HullMeasure(const std::vector<Vector2>& polygon, const std::vector<HullCorner>& corners, int segments);

    /// A stretch between two corners, or the closed outline.
    struct Piece
    {
        /// At its ends and between them, at equal steps of length and turn together: cumulated measure from
        /// 0, and angle of the outward normal [rad], rising along all pieces.
        std::vector<double> measures;
        std::vector<double> angles;
        /// Angles of the normals at its ends, for a corner to start or end with: extrapolated from the
        /// polygon's edges beside it.
        double startAngle = 0;
        double endAngle = 0;
        /// No vertex is further than 0.75 pixels from the chord.
        bool straight = false;

        double measure() const { return measures.back(); }
        double turn() const { return angles.back() - angles.front(); }
        double angleAt(double measure) const;
    };

    /// Piece k follows corner k.
    const std::vector<Piece>& pieces() const { return pieces_; }

    /// Says which pieces are straight, for pixels of this size.
    void findStraightPieces(const std::vector<Vector2>& polygon, const std::vector<HullCorner>& corners,
                            double pixel);

private:
    std::vector<Piece> pieces_;
};

} // namespace chesil
