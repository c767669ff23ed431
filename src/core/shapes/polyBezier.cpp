#include "core/shapes/polyBezier.hpp"

#include "core/base/sizeRange.hpp"
#include "core/base/tolerances.hpp"
#include "core/geometry/convexity.hpp"
#include "core/shapes/centring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

void requireClosed(const std::vector<CubicBezier>& segments)
{
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
        const std::size_t next = (i + 1) % segments.size();
        if (segments[i].end() != segments[next].start())
        {
            throw ValueError(
                "segment " + std::to_string(i) + " ends " + numberText((segments[i].end() - segments[next].start()).norm())
                    + " m away from the start of segment " + std::to_string(next),
                "segments joined end to start");
        }
        if (segments[i].startTangent() == Vector2::Zero())
        {
            throw ValueError("segment " + std::to_string(i) + " with four equal control points", "segments of a positive length");
        }
    }
}

/// Two roots in (0, 1) would be beyond the closed form of the support point.
void requireHalfTurnAtMost(const std::vector<CubicBezier>& segments)
{
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
        const auto& points = segments[i].controlPoints();
        Vector2 tangent = segments[i].startTangent();
        double turn = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const Vector2 edge = points[k + 1] - points[k];
            if (edge != Vector2::Zero())
            {
                turn += std::atan2(cross(tangent, edge), tangent.dot(edge));
                tangent = edge;
            }
        }
        if (turn > M_PI + tolerances::convexity)
        {
            throw ValueError(
                "segment " + std::to_string(i) + " turns by " + numberText(turn * 180 / M_PI) + " degrees",
                "segments that turn by at most 180 degrees (split this one)");
        }
    }
}

std::vector<Vector2> controlPolygon(const std::vector<CubicBezier>& segments)
{
    std::vector<Vector2> vertices;
    for (const CubicBezier& segment : segments)
    {
        const auto& points = segment.controlPoints();
        vertices.insert(vertices.end(), points.begin(), points.begin() + 3);
    }
    return vertices;
}

/// Parts leave the curve by the square of their length only: enough of them for distances, and for radii of curvature.
constexpr int partsForDistance = 16;
constexpr int partsForRadius = 8;

std::vector<CubicBezier> partsOf(const CubicBezier& segment, int count)
{
    std::vector<CubicBezier> parts;
    for (int i = 0; i < count; ++i)
    {
        parts.push_back(segment.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
    }
    return parts;
}

/// A bound on the distance of the segment from the origin, since the broad phase trusts it: the furthest control
/// point of its parts.
double furthestPoint(const CubicBezier& segment)
{
    double furthest = 0;
    for (const CubicBezier& part : partsOf(segment, partsForDistance))
    {
        for (const Vector2& point : part.controlPoints())
        {
            furthest = std::max(furthest, point.norm());
        }
    }
    return furthest;
}

/// How near the chords of the segment's parts, all inside the grain, come to the origin.
double nearestChord(const CubicBezier& segment)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const CubicBezier& part : partsOf(segment, partsForDistance))
    {
        const Vector2 chord = part.end() - part.start();
        if (chord != Vector2::Zero())
        {
            nearest = std::min(nearest, cross(part.start(), chord) / chord.norm());
        }
    }
    return std::max(0.0, nearest);
}

Vector2 outwardNormal(const Vector2& tangent)
{
    return -perpendicular(tangent).normalized();
}

/// A stretch of the outline between two normals, with a lower bound of its radius of curvature [m].
struct Stretch
{
    double leastRadius;
    Vector2 firstNormal;
    Vector2 lastNormal;
};

Stretch stretchOf(const CubicBezier& curve)
{
    return {curve.leastCurvatureRadius(), outwardNormal(curve.startTangent()), outwardNormal(curve.endTangent())};
}

bool isStraight(const Stretch& stretch)
{
    return cross(stretch.firstNormal, stretch.lastNormal) <= tolerances::sameNormal
        && stretch.firstNormal.dot(stretch.lastNormal) > 0;
}

} // namespace

PolyBezier::PolyBezier(const std::vector<CubicBezier>& segments)
{
    if (segments.size() < 2)
    {
        throw ValueError(std::to_string(segments.size()) + " segments", "at least 2");
    }
    requireClosed(segments);
    requireConvex(controlPolygon(segments));
    requireHalfTurnAtMost(segments);

    CentredBoundary boundary = centred(segments);
    segments_ = std::move(boundary.segments);
    givenCentroid_ = boundary.givenCentroid;
    mass_ = boundary.mass;

    innerRadius_ = std::numeric_limits<double>::infinity();
    std::vector<Vector2> starts;
    const auto addPart = [&](const Stretch& part)
    {
        partStarts_.push_back(part.firstNormal);
        partRadii_.push_back(part.leastRadius);
    };
    const auto addCurve = [&](const CubicBezier& curve, const Stretch& stretch)
    {
        curves_.push_back(curve);
        ranges_.push_back({stretch.firstNormal, stretch.lastNormal});
        starts.push_back(stretch.firstNormal);
    };
    for (std::size_t i = 0; i < segments_.size(); ++i)
    {
        const CubicBezier& segment = segments_[i];
        boundingRadius_ = std::max(boundingRadius_, furthestPoint(segment));
        innerRadius_ = std::min(innerRadius_, nearestChord(segment));

        const Stretch stretch = stretchOf(segment);
        addCurve(segment, stretch);
        if (isStraight(stretch))
        {
            straightSides_.push_back({outwardNormal(segment.end() - segment.start()), segment.start(), segment.end()});
            addPart(stretch);
        }
        else
        {
            for (const CubicBezier& part : partsOf(segment, partsForRadius))
            {
                addPart(stretchOf(part));
            }
        }
        const Vector2 nextNormal = outwardNormal(segments_[(i + 1) % segments_.size()].startTangent());
        if (cross(stretch.lastNormal, nextNormal) > tolerances::joint)
        {
            const Vector2& corner = segment.end();
            const Stretch atCorner{0, stretch.lastNormal, nextNormal};
            addCurve(CubicBezier({corner, corner, corner, corner}), atCorner);
            addPart(atCorner);
        }
    }
    requireSize(boundingRadius_, "an outline with a bounding radius");
    leastRadius_ = *std::min_element(partRadii_.begin(), partRadii_.end());
    normals_ = NormalTable(starts);
    partNormals_ = NormalTable(partStarts_);
}

double PolyBezier::roomAtCorner(std::size_t piece, const Vector2& normal) const
{
    const auto& [first, last] = ranges_[piece];
    return std::max(0.0, std::min(cross(first, normal), cross(normal, last)));
}

CurvedCoordinates<TwoLanes> PolyBezier::searchedCurvedSupports(
    const PolyBezier& a, const PolyBezier& b, const TwoLanes& x, const TwoLanes& y, PieceGuess& guess)
{
    const Vector2 normalA(x[0], y[0]);
    const Vector2 normalB(x[1], y[1]);
    const std::size_t pieceA = a.normals_.find(normalA);
    const std::size_t pieceB = b.normals_.find(normalB);
    guess = PieceGuess::of(pieceA, pieceB);
    CurvedCoordinates<TwoLanes> result = curvedSupportOf(sideBySide(a.curves_[pieceA], b.curves_[pieceB], x, y));
    if (!areAll(result.radius != 0))
    {
        const TwoLanes rooms{a.roomAtCorner(pieceA, normalA), b.roomAtCorner(pieceB, normalB)};
        result.room = result.radius == 0 ? rooms : result.room;
    }
    return result;
}

double PolyBezier::leastRadiusBetween(const Vector2& first, const Vector2& last) const
{
    const std::size_t end = partNormals_.find(last);
    std::size_t part = partNormals_.find(first);
    double least = partRadii_[part];
    while (part != end)
    {
        part = partAfter(part);
        least = std::min(least, partRadii_[part]);
    }
    return least;
}

const StraightSide* PolyBezier::straightSideFacing(const Vector2& normal) const
{
    const StraightSide* facing = nullptr;
    for (const StraightSide& side : straightSides_)
    {
        if (!facing || side.normal.dot(normal) > facing->normal.dot(normal))
        {
            facing = &side;
        }
    }
    return facing;
}

const StraightSide* PolyBezier::straightSideBetween(const Vector2& from, const Vector2& to) const
{
    const double sense = cross(from, to) > 0 ? 1 : -1;
    for (const StraightSide& side : straightSides_)
    {
        if (sense * cross(from, side.normal) > tolerances::sameNormal
            && sense * cross(side.normal, to) > tolerances::sameNormal)
        {
            return &side;
        }
    }
    return nullptr;
}

double PolyBezier::largestJointAngle() const
{
    double largest = 0;
    for (std::size_t i = 0; i < segments_.size(); ++i)
    {
        const Vector2 before = segments_[i].endTangent();
        const Vector2 after = segments_[(i + 1) % segments_.size()].startTangent();
        largest = std::max(largest, std::abs(std::atan2(cross(before, after), before.dot(after))));
    }
    return largest;
}

} // namespace chesil
