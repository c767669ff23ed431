#pragma once

#include "core/base/supportContract.hpp"
#include "core/base/tolerances.hpp"
#include "core/base/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace chesil
{

/// The straight side that another shape presses into: a point on it, its outward unit normal, and how far it reaches
/// from the point along perpendicular(normal) [m].
struct ReferenceSide
{
    Vector2 point;
    Vector2 normal;
    double from;
    double to;
};

/// One end of a flat contact. As the reference moves against the other shape, its depth grows by
/// way . (weight normal + depthPerWay) + turn depthPerTurn, with the way of the contact's point and the turn about it.
struct FlatPlace
{
    /// Overlap there [m], at the shallower end times its weight; not positive if this end hangs free.
    double depth;
    /// Unit, out of the reference: its side's normal where a corner of the other shape presses into it; the other side's,
    /// reversed, where a corner of the reference presses into that.
    Vector2 normal;
    /// Middle of the overlap [m].
    Vector2 point;
    bool cornerOfReference = false;
    double weight = 1;
    /// What the weight's own change adds.
    Vector2 depthPerWay = Vector2::Zero();
    /// [m/rad].
    double depthPerTurn = 0;
};

/// Weight of the shallower place, between 0 and 1, and its derivatives.
struct FlatWeight
{
    /// Largest tilt of a shallow contact (sine).
    static constexpr double mostTilt = tolerances::oneSide;
    /// Deeper contacts may tilt further, by this over the ratio of length to depth: the couple, which goes with the
    /// depth over the tilt, stays below what the contacts of the stable time step give.
    static constexpr double mostTiltTimesRatio = 0.5;
    /// Up to this ratio of length to depth there is one place: where the side of least depth changes at a corner whose sides
    /// stand at an angle of f, it is tan(f/2), 1 for a square and 1.7 for a triangle of equal sides.
    static constexpr double leastRatio = 2;

    double value = 0;
    double perTilt = 0;
    double perRatio = 0;

    /// Of the sides' sine `tilt` and the shared length over the larger depth, `ratio` > 0. Smooth in both: the product of
    /// (1 - (tilt/most)^2)^2 and a cubic that rises from 0 at leastRatio to 1 at twice that.
    static FlatWeight of(double tilt, double ratio)
    {
        const double most = mostTilt + mostTiltTimesRatio / ratio;
        const double share = tilt / most;
        const double left = 1 - share * share;
        const double length = std::min(ratio / leastRatio - 1, 1.0);
        if (!(left > 0 && length > 0))
        {
            return {};
        }
        const double ofTilt = left * left;
        const double ofLength = length * length * (3 - 2 * length);
        const double perShare = -4 * share * left * ofLength;
        const double perLength = ofTilt * 6 * length * (1 - length);
        return {
            ofTilt * ofLength,
            perShare / most,
            perLength / leastRatio + perShare * share * mostTiltTimesRatio / (most * ratio * ratio)};
    }
};

/// Gives the shallower place its weight. `along`: unit, midway between the sides, towards places[1]; `tilt`: sine of the angle
/// between them, and its derivative by a turn of the reference.
inline void weigh(std::array<FlatPlace, 2>& places, const Vector2& along, double tilt, double tiltPerTurn)
{
    const std::size_t deep = places[0].depth >= places[1].depth ? 0 : 1;
    const FlatPlace& deeper = places[deep];
    FlatPlace& shallower = places[1 - deep];
    if (!(shallower.depth > 0))
    {
        return;
    }
    std::array<Vector2, 2> corners;
    for (std::size_t i = 0; i < 2; ++i)
    {
        corners[i] = places[i].point + (places[i].cornerOfReference ? 0.5 : -0.5) * places[i].depth * places[i].normal;
    }
    const Vector2 between = corners[1] - corners[0];
    const double ratio = between.dot(along) / deeper.depth;
    const FlatWeight weight = FlatWeight::of(tilt, ratio);

    // Of the length: by the corners that move with the reference, and by the turn of the line, half of the reference's
    double lengthPerWay = 0;
    double lengthPerTurn = between.dot(perpendicular(along)) / 2;
    for (std::size_t i = 0; i < 2; ++i)
    {
        if (places[i].cornerOfReference)
        {
            const double sign = i == 0 ? -1 : 1;
            lengthPerWay += sign;
            lengthPerTurn += sign * cross(corners[i] - shallower.point, along);
        }
    }
    const double perTilt = shallower.depth * weight.perTilt;
    const double perLength = shallower.depth * weight.perRatio / deeper.depth;
    const double perDeeper = -perLength * ratio;
    shallower.weight = weight.value;
    shallower.depth *= weight.value;
    shallower.depthPerWay = perLength * lengthPerWay * along + perDeeper * deeper.normal;
    shallower.depthPerTurn = perTilt * tiltPerTurn + perLength * lengthPerTurn
        + perDeeper * cross(deeper.point - shallower.point, deeper.normal);
}

/// Both ends of the contact of a reference side with a straight side of another shape, whose deepest point is `deepest`; in the
/// order of perpendicular(reference.normal). The ends of the shared length, as seen along the line midway between the sides,
/// are corners of one shape or the other: the depth at each is a continuous function of the poses, whichever side is the
/// reference. Where the deepest point lies beyond an end of its side (a rounded corner), it stands in for that end.
/// doc/contactKernel.md, "Flat contacts".
inline std::array<FlatPlace, 2> flatPlaces(const ReferenceSide& reference, const StraightSide& incident, const Vector2& deepest)
{
    const auto ofIncident = [&](const Vector2& corner) -> FlatPlace
    {
        const double depth = (reference.point - corner).dot(reference.normal);
        return {depth, reference.normal, corner + depth / 2 * reference.normal};
    };
    // The side runs counter-clockwise in its own shape, against the reference.
    Vector2 low = incident.end;
    Vector2 high = incident.start;
    const bool nearLow = (deepest - low).squaredNorm() <= (deepest - high).squaredNorm();
    const auto alone = [&]
    {
        const FlatPlace whole = ofIncident(deepest);
        const FlatPlace none{0, reference.normal, deepest};
        return nearLow ? std::array<FlatPlace, 2>{whole, none} : std::array<FlatPlace, 2>{none, whole};
    };
    const double tilt = cross(incident.normal, reference.normal);
    const double facing = -incident.normal.dot(reference.normal);
    if (!(facing > 0 && std::abs(tilt) < FlatWeight::mostTilt + FlatWeight::mostTiltTimesRatio / FlatWeight::leastRatio))
    {
        return alone();
    }

    const Vector2 along = perpendicular(unit(reference.normal - incident.normal));
    const auto coordinate = [&](const Vector2& p) { return (p - reference.point).dot(along); };
    // Not a point between them: that of a side exactly parallel is any.
    if (nearLow ? coordinate(deepest) < coordinate(low) : coordinate(deepest) > coordinate(high))
    {
        (nearLow ? low : high) = deepest;
    }
    // Where a rounded corner stands in, the line to it lies within the shape, that of the side does not.
    const Vector2 opposite = perpendicular(unit(high - low));
    const auto ofReference = [&](double x) -> FlatPlace
    {
        const Vector2 corner = reference.point + x * perpendicular(reference.normal);
        const double depth = (high - corner).dot(opposite);
        return {depth, -opposite, corner + depth / 2 * opposite, true};
    };
    const double shortening = perpendicular(reference.normal).dot(along);
    const double from = reference.from * shortening;
    const double to = reference.to * shortening;
    const double x0 = coordinate(low);
    const double x1 = coordinate(high);
    if (!(std::max(x0, from) < std::min(x1, to)))
    {
        return alone();
    }
    std::array<FlatPlace, 2> places{
        x0 >= from ? ofIncident(low) : ofReference(reference.from), x1 <= to ? ofIncident(high) : ofReference(reference.to)};
    weigh(places, along, tilt, -facing);
    return places;
}

} // namespace chesil
