#pragma once

#include "core/base/tolerances.hpp"
#include "core/narrowphase/minkowskiDifference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

/// How the search for a valley ended.
enum class ValleyStatus
{
    /// A local minimum of the height.
    found,
    /// On the way a direction was met that separates the shapes.
    separated,
    /// No valley within the limit of rounds.
    roundLimit,
    /// A support point is not a number.
    notFinite,
};

/// Whether a direction that separates the shapes is all one wants to know.
enum class SeparatedPairs
{
    stop,
    goOn,
};

/// A local minimum of the height h(n) = max over p in A - B of n.p, over unit normals n. World axes, relative to A's
/// centroid [m].
struct Valley
{
    ValleyStatus status;
    Vector2 normal;
    /// h(normal): the penetration depth; negative for the distance of separated shapes.
    double height;
    /// Deepest point of A in B, or nearest to B.
    Vector2 onA;
    /// The boundary of A - B at this normal: both ends of a straight side, the same point twice elsewhere.
    Vector2 start;
    Vector2 end;
    bool onStraightSide;
};

/// Walks from a first guess down the height of A - B to its nearest local minimum. Newton's step takes the boundary
/// for its circle of curvature; where the minimum is fenced in between two normals, the chord of their support
/// points (EPA's step) is the safeguard; straight sides are tried as such. doc/contactKernel.md derives it.
template <class Difference>
class ValleySearch
{
public:
    explicit ValleySearch(const Difference& difference)
    : difference_(difference), size_(difference.size()), floor_(tolerances::supportRounding / 2 * size_), unsettled_(mostToGain * size_)
    {
    }

    /// `normal` is where to start, of unit length.
    [[gnu::flatten]] Valley from(Vector2 normal, SeparatedPairs separatedPairs)
    {
        CurvedVertex<2> vertex = difference_.curvedSupport(normal);
        double previousTurn = 0;
        double previousRadius = 0;
        for (int round = 0; round < mostRounds; ++round)
        {
            const double height = normal.dot(vertex.difference);
            const double slope = cross(normal, vertex.difference);
            if (!std::isfinite(height + slope))
            {
                return ended(ValleyStatus::notFinite, normal, height, vertex);
            }
            if (height < 0 && separatedPairs == SeparatedPairs::stop)
            {
                return ended(ValleyStatus::separated, normal, height, vertex);
            }

            const double bend = vertex.radius() - height;
            const bool curved = bend > 0 && std::isfinite(bend);
            const double turn = curved ? slope / bend : 0;
            const double radius = vertex.radius();
            if (curved && slope * slope <= unsettled_ * std::min(bend, size_))
            {
                const ThirdOrder third = thirdOrder(slope, turn, radius, previousTurn, previousRadius, vertex.room);
                if (isSettled(slope, turn, bend, vertex.room, third))
                {
                    // The third order is a small correction, or says nothing: at a joint of unlike curves.
                    const bool small = std::abs(third.radiusChange * turn) < smallChange * bend;
                    return atBottom(normal, vertex, height, slope, small ? third.radiusChange : 0);
                }
            }
            if (slope == 0)
            {
                // Stationary: the bottom, or (the boundary bends more than a circle about the origin) a ridge.
                return ended(bend >= 0 ? ValleyStatus::found : ValleyStatus::roundLimit, normal, height, vertex);
            }

            (slope < 0 ? clockwise_ : counterClockwise_) = {normal, vertex, true};
            Vector2 next = curved ? unit(vertex.radius() * normal - vertex.difference) : turnedDownhill(normal, slope);
            bool newton = curved;
            bool chord = false;
            if (clockwise_.known && counterClockwise_.known
                && (!newton || !isFencedIn(next) || (previousTurn != 0 && 2 * std::abs(turn) > std::abs(previousTurn))))
            {
                next = chordNormal();
                if (!isFencedIn(next))
                {
                    return atFences();
                }
                newton = false;
                chord = true;
            }
            previousTurn = newton ? turn : 0;
            previousRadius = radius;

            if constexpr (Difference::mayHaveStraightSides())
            {
                DifferenceSide side;
                if (difference_.straightSideBetween(normal, next, side))
                {
                    const double atStart = cross(side.normal, side.start.difference);
                    const double atEnd = cross(side.normal, side.end.difference);
                    if (atStart <= 0 && atEnd >= 0)
                    {
                        return atSide(side, atStart, atEnd, separatedPairs);
                    }
                    normal = side.normal;
                    vertex = atStart > 0 ? side.start : side.end;
                    previousTurn = 0;
                    continue;
                }
            }

            normal = next;
            vertex = difference_.curvedSupport(normal);
            if (chord)
            {
                const double beyondChord = normal.dot(vertex.difference) - normal.dot(clockwise_.vertex.difference);
                if (beyondChord <= floor_)
                {
                    return atChordOrBottom(normal, vertex);
                }
            }
        }
        return ended(ValleyStatus::roundLimit, normal, normal.dot(vertex.difference), vertex);
    }

private:
    /// Newton takes about four from a bad guess; the chord wins a factor of four a round, of the 2^50 that there are.
    static constexpr int mostRounds = 40;
    /// A turn [rad] whose fourth order is below rounding.
    static constexpr double smallTurn = 1e-4;
    /// Twice a gain over the size beyond which the third order never settles a search, so that it need not be looked at.
    static constexpr double mostToGain = 1e-7;
    /// The third order over the second beyond which it is no correction.
    static constexpr double smallChange = 1e-2;

    /// A normal on one side of the minimum, and its support point.
    struct Fence
    {
        Vector2 normal;
        CurvedVertex<2> vertex;
        bool known = false;
    };

    /// What two of Newton's steps in a row tell of the change of the radius of curvature.
    struct ThirdOrder
    {
        /// Both steps are on one curve; else nothing is known.
        bool known;
        /// Derivative of the radius by the angle [m].
        double radiusChange;
        /// Largest that this derivative, by the radii or by the slope that the last step left, can be; times turn^2 [m].
        double change;
        double previousTurn;
    };

    static ThirdOrder thirdOrder(
        double slope, double turn, double radius, double previousTurn, double previousRadius, double room)
    {
        if (previousTurn == 0 || std::abs(previousTurn) > room)
        {
            return {false, 0, 0, 0};
        }
        const double inverse = 1 / previousTurn;
        const double radiusChange = (previousRadius - radius) * inverse;
        // h' after the last step is radiusChange previousTurn^2/2.
        const double seenChange = 2 * std::abs(slope) * inverse * inverse;
        return {
            true, radiusChange, std::max({std::abs(radiusChange), seenChange, radius}) * turn * turn, std::abs(previousTurn)};
    }

    /// What is still to gain on a circle of curvature is nothing, if the outline keeps to it; or, after two of Newton's
    /// steps in a row, the third-order term that the circle leaves out and the last step adds is, with a digit to spare,
    /// and that step leaves hardly anything of the normal's angle.
    bool isSettled(double slope, double turn, double bend, double room, const ThirdOrder& third) const
    {
        if (2 * std::abs(turn) > room)
        {
            return std::abs(slope) <= floor_;
        }
        if (slope * slope <= 2 * floor_ * std::min(bend, size_))
        {
            return true;
        }
        return third.known && third.change * third.previousTurn <= tolerances::settledNormal * bend
            && third.change * std::abs(turn) <= floor_;
    }

    static Valley ended(ValleyStatus status, const Vector2& normal, double height, const CurvedVertex<2>& vertex)
    {
        return {status, normal, height, vertex.onA, vertex.difference, vertex.difference, false};
    }

    /// Newton's last step: the normal turns to the bottom of the circle of curvature, and by what the change of that
    /// circle (the derivative of its radius by the angle [m]) adds; A's point goes along.
    static Valley atBottom(
        const Vector2& normal, const CurvedVertex<2>& vertex, double height, double slope, double radiusChange)
    {
        const double bend = vertex.radius() - height;
        const double angle = -slope / bend;
        if (!(std::abs(angle) < smallTurn))
        {
            return atBottomOfCircle(normal, vertex, height, slope);
        }
        const double more = radiusChange * angle * angle / (2 * bend);
        const Vector2 bottom = turnedBy(angle - more, normal);
        const double lowest = height + angle * (slope / 2 + radiusChange * angle * angle / 6);
        // Along the arc: on a nearly straight side the difference of the two normals has no digits left.
        const double along = angle * vertex.radiusA;
        const Vector2 onA = vertex.onA + along * perpendicular(normal) - along * angle / 2 * normal;
        const Vector2 onDifference = lowest * bottom;
        return {ValleyStatus::found, bottom, lowest, onA, onDifference, onDifference, false};
    }

    /// However far it turns: a boundary round about the origin.
    static Valley atBottomOfCircle(const Vector2& normal, const CurvedVertex<2>& vertex, double height, double slope)
    {
        const Vector2 fromCentre = vertex.radius() * normal - vertex.difference;
        const double distance = fromCentre.norm();
        if (!(distance > 0))
        {
            return ended(ValleyStatus::found, normal, height, vertex);
        }
        const Vector2 bottom = (1 / distance) * fromCentre;
        const double lowest = height - slope * slope / (distance + vertex.radius() - height);
        const Vector2 onDifference = lowest * bottom;
        return {
            ValleyStatus::found, bottom, lowest, vertex.onA + vertex.radiusA * (bottom - normal), onDifference, onDifference,
            false};
    }

    /// A unit vector turned counter-clockwise by 2 atan(angle/2), a turn of `angle` but for angle^3/12, without a root.
    static Vector2 turnedBy(double angle, const Vector2& normal)
    {
        const double half = angle / 2;
        const double scale = 2 / (1 + half * half);
        return (scale - 1) * normal + half * scale * perpendicular(normal);
    }

    static Valley atSide(const DifferenceSide& side, double atStart, double atEnd, SeparatedPairs separatedPairs)
    {
        const double height = side.normal.dot(side.start.difference);
        const double length = atEnd - atStart;
        const double share = length > 0 ? -atStart / length : 0.5;
        const Vector2 onA = side.start.onA + share * (side.end.onA - side.start.onA);
        const bool separated = height < 0 && separatedPairs == SeparatedPairs::stop;
        return {
            separated ? ValleyStatus::separated : ValleyStatus::found,
            side.normal,
            height,
            onA,
            side.start.difference,
            side.end.difference,
            true};
    }

    /// The minimum lies between two fences with no normal between them: at the lower one, but for rounding.
    Valley atFences() const
    {
        const double first = clockwise_.normal.dot(clockwise_.vertex.difference);
        const double last = counterClockwise_.normal.dot(counterClockwise_.vertex.difference);
        const Fence& lower = first <= last ? clockwise_ : counterClockwise_;
        return between(lower.normal, std::min(first, last));
    }

    /// The support point along the chord's normal is on the chord, but for rounding: a straight side, or a curve so
    /// short that its own circle is as good and knows the normal better.
    Valley atChordOrBottom(const Vector2& normal, const CurvedVertex<2>& vertex) const
    {
        const double height = normal.dot(vertex.difference);
        const double slope = cross(normal, vertex.difference);
        const double bend = vertex.radius() - height;
        if (bend > 0 && 2 * std::abs(slope) <= vertex.room * bend && slope * slope <= 2 * floor_ * std::min(bend, size_)
            && isFencedIn(unit(vertex.radius() * normal - vertex.difference)))
        {
            return atBottom(normal, vertex, height, slope, 0);
        }
        return atChord(normal);
    }

    /// The minimum lies between the two fences, and their chord is a side of A - B but for rounding.
    Valley atChord(const Vector2& normal) const
    {
        return between(
            normal, std::max(normal.dot(clockwise_.vertex.difference), normal.dot(counterClockwise_.vertex.difference)));
    }

    /// On the chord from fence to fence, where it is nearest to the origin.
    Valley between(const Vector2& normal, double height) const
    {
        const CurvedVertex<2>& first = clockwise_.vertex;
        const CurvedVertex<2>& last = counterClockwise_.vertex;
        const Vector2 chord = last.difference - first.difference;
        const double squaredLength = chord.squaredNorm();
        const double share =
            squaredLength > 0 ? std::min(1.0, std::max(0.0, -first.difference.dot(chord) / squaredLength)) : 0.0;
        const Vector2 onA = first.onA + share * (last.onA - first.onA);
        return {ValleyStatus::found, normal, height, onA, first.difference, last.difference, true};
    }

    /// Outward normal of the chord from fence to fence; zero if that has no length.
    Vector2 chordNormal() const
    {
        const Vector2 chord = counterClockwise_.vertex.difference - clockwise_.vertex.difference;
        const double length = chord.norm();
        return length > 0 ? Vector2(-perpendicular(chord) / length) : Vector2(Vector2::Zero());
    }

    bool isFencedIn(const Vector2& normal) const
    {
        return cross(clockwise_.normal, normal) > tolerances::sameNormal
            && cross(normal, counterClockwise_.normal) > tolerances::sameNormal;
    }

    /// By 27 degrees: where the boundary bends too little for Newton's step.
    static Vector2 turnedDownhill(const Vector2& normal, double slope)
    {
        return unit(normal + (slope < 0 ? 0.5 : -0.5) * perpendicular(normal));
    }

    const Difference& difference_;
    double size_;
    /// What is as good as nothing of a height: half of a support point's rounding.
    double floor_;
    /// Twice the gain above which no step is the last [m].
    double unsettled_;
    Fence clockwise_;
    Fence counterClockwise_;
};

} // namespace chesil
