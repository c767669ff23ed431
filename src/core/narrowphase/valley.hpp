#pragma once

#include "core/base/tolerances.hpp"
#include "core/narrowphase/valleyBottom.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

/// Whether a direction that separates the shapes is all one wants to know.
enum class SeparatedPairs
{
    stop,
    goOn,
};

/// Walks from a first guess down the height of A - B to its nearest local minimum. Newton's step takes the boundary
/// for its circle of curvature; where the minimum is fenced in between two normals, the chord of their support
/// points (EPA's step) is the safeguard; straight sides are tried as such. doc/contactKernel.md derives it.
template <class Difference>
class ValleySearch
{
public:
    explicit ValleySearch(const Difference& difference)
    : difference_(difference), size_(difference.size()), floor_(tolerances::supportRounding / 2 * size_)
    {
    }

    /// `normal` is where to start, of unit length. Most often one look is enough: a warm contact's, or that a pair is apart.
    Valley from(const Vector2& normal, SeparatedPairs separatedPairs)
    {
        const CurvedVertex<2> vertex = difference_.curvedSupport(normal);
        const double height = normal.dot(vertex.difference);
        const double slope = cross(normal, vertex.difference);
        if (height < 0 && std::isfinite(height + slope) && separatedPairs == SeparatedPairs::stop)
        {
            return valleyAt(ValleyStatus::separated, normal, height, vertex);
        }
        const double bend = vertex.radius.value - height;
        if (height >= 0 && bend > 0 && std::isfinite(bend) && isSettled(slope, slope / bend, bend, vertex))
        {
            return atBottom(normal, vertex, height, slope);
        }
        return walk(normal, vertex, separatedPairs);
    }

private:
    /// Not inlined, so that it leaves the registers to what goes before.
    [[gnu::noinline, gnu::flatten]] Valley walk(Vector2 normal, CurvedVertex<2> vertex, SeparatedPairs separatedPairs)
    {
        double previousTurn = 0;
        for (int round = 0; round < mostRounds; ++round)
        {
            const double height = normal.dot(vertex.difference);
            const double slope = cross(normal, vertex.difference);
            if (!std::isfinite(height + slope))
            {
                return valleyAt(ValleyStatus::notFinite, normal, height, vertex);
            }
            if (height < 0 && separatedPairs == SeparatedPairs::stop)
            {
                return valleyAt(ValleyStatus::separated, normal, height, vertex);
            }

            const double radius = vertex.radius.value;
            const double bend = radius - height;
            const bool curved = bend > 0 && std::isfinite(bend);
            const double turn = curved ? slope / bend : 0;
            if (curved && isSettled(slope, turn, bend, vertex))
            {
                return atBottom(normal, vertex, height, slope);
            }
            if (slope == 0)
            {
                // Stationary: the bottom, or (the boundary bends more than a circle about the origin) a ridge.
                return valleyAt(bend >= 0 ? ValleyStatus::found : ValleyStatus::roundLimit, normal, height, vertex);
            }

            (slope < 0 ? clockwise_ : counterClockwise_) = {normal, {vertex.difference, vertex.onA}, true};
            Vector2 next = curved ? unit(radius * normal - vertex.difference) : turnedDownhill(normal, slope);
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
        return valleyAt(ValleyStatus::roundLimit, normal, normal.dot(vertex.difference), vertex);
    }

    /// Newton takes about four from a bad guess; the chord wins a factor of four a round, of the 2^50 that there are.
    static constexpr int mostRounds = 40;
    /// A normal on one side of the minimum, and its support point.
    struct Fence
    {
        Vector2 normal;
        SupportVertex<2> vertex;
        bool known = false;
    };

    /// Whether what the series about this normal (doc/contactKernel.md, "The last step") leaves out of the minimum's height and
    /// normal is nothing. Its next term is judged by the growth of the terms before.
    bool isSettled(double slope, double turn, double bend, const CurvedVertex<2>& vertex) const
    {
        if (2 * std::abs(turn) > vertex.room)
        {
            return std::abs(slope) <= floor_;
        }
        if (slope * slope <= 2 * floor_ * std::min(bend, size_))
        {
            return true;
        }
        if (!(std::abs(turn) < smallTurn))
        {
            return false;
        }
        // With g, the growth of the radius' Taylor coefficients (radius^2 g^2 = growth), the series leaves radius g^4 turn^4
        // of h'. Twice g, since both derivatives may be small by chance.
        constexpr double safety = 16;
        const CurvatureRadius& radius = vertex.radius;
        const double growth = std::max({radius.value * radius.value, radius.first * radius.first, radius.value * std::abs(radius.second)});
        const double cubed = radius.value * radius.value * radius.value;
        const double left = safety * growth * growth * (turn * turn) * (turn * turn);
        return left <= tolerances::settledNormal * bend * cubed && left * std::abs(turn) <= floor_ * cubed;
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
        const double bend = vertex.radius.value - height;
        if (bend > 0 && 2 * std::abs(slope) <= vertex.room * bend && slope * slope <= 2 * floor_ * std::min(bend, size_)
            && isFencedIn(unit(vertex.radius.value * normal - vertex.difference)))
        {
            return atBottom(normal, vertex, height, slope);
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
        const SupportVertex<2>& first = clockwise_.vertex;
        const SupportVertex<2>& last = counterClockwise_.vertex;
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
    Fence clockwise_;
    Fence counterClockwise_;
};

} // namespace chesil
