#include "coupling/geometry/clippedRegion.hpp"

#include <algorithm>

namespace chesil
{

namespace
{

Vector2 pointAt(const OutlinePiece& curve, double parameter)
{
    return std::visit([parameter](const auto& c) { return c.at(parameter); }, curve);
}

/// The chord's part inside; the end that is cut off moves to the line.
BoundaryPiece chordInside(const BoundaryPiece& piece, double distanceStart, double distanceEnd)
{
    BoundaryPiece inside = piece;
    const Vector2 crossing =
        piece.start + (piece.end - piece.start) * (distanceStart / (distanceStart - distanceEnd));
    (distanceStart < 0 ? inside.start : inside.end) = crossing;
    return inside;
}

} // namespace

void ClippedRegion::start(const TurnedOutline& outline)
{
    outline_ = &outline;
    pieces_ = outline.chain();
}

void ClippedRegion::append(const BoundaryPiece& piece)
{
    if (!kept_.empty() && kept_.back().end != piece.start)
    {
        kept_.push_back({BoundaryPiece::chord, 0, 0, kept_.back().end, piece.start});
    }
    kept_.push_back(piece);
}

void ClippedRegion::appendInside(const BoundaryPiece& piece, const HalfPlane& plane)
{
    const double distanceStart = plane.distance(piece.start);
    const double distanceEnd = plane.distance(piece.end);
    if (piece.curve == BoundaryPiece::chord)
    {
        if (distanceStart >= 0 && distanceEnd >= 0)
        {
            append(piece);
        }
        else if (distanceStart >= 0 || distanceEnd >= 0)
        {
            append(chordInside(piece, distanceStart, distanceEnd));
        }
        return;
    }

    const OutlinePiece& curve = outline_->curves()[piece.curve];
    const CubicBezier* cubic = std::get_if<CubicBezier>(&curve);
    const ParameterRanges inside =
        cubic ? partsInside(*cubic, piece.from, piece.to, distanceStart, distanceEnd, plane)
              : partsInside(std::get<EllipticArc>(curve), piece.from, piece.to, plane);
    for (const auto& range : inside)
    {
        append({piece.curve, range.from, range.to,
                range.from == piece.from ? piece.start : pointAt(curve, range.from),
                range.to == piece.to ? piece.end : pointAt(curve, range.to)});
    }
}

void ClippedRegion::cut(const HalfPlane& plane)
{
    kept_.clear();
    for (const BoundaryPiece& piece : pieces_)
    {
        appendInside(piece, plane);
    }
    if (!kept_.empty() && kept_.back().end != kept_.front().start)
    {
        kept_.push_back({BoundaryPiece::chord, 0, 0, kept_.back().end, kept_.front().start});
    }
    std::swap(pieces_, kept_);
}

bool ClippedRegion::boundedByLines() const
{
    return std::all_of(pieces_.begin(), pieces_.end(),
                       [](const BoundaryPiece& piece) { return piece.curve == BoundaryPiece::chord; });
}

RegionMoments ClippedRegion::moments() const
{
    if (pieces_.empty())
    {
        return {};
    }
    const Vector2 reference = pieces_.front().start;
    RegionMoments total;
    for (const BoundaryPiece& piece : pieces_)
    {
        const Vector2 start = piece.start - reference;
        total += triangleMoments(start, piece.end - reference);
        if (piece.curve == BoundaryPiece::chord)
        {
            continue;
        }
        const OutlinePiece& curve = outline_->curves()[piece.curve];
        const CubicBezier* cubic = std::get_if<CubicBezier>(&curve);
        const RegionMoments sliver =
            cubic ? sliverMoments(*cubic, piece.from, piece.to)
                  : sliverMoments(std::get<EllipticArc>(curve), piece.from, piece.to, piece.start);
        total += sliver.aboutPoint(-start);
    }
    return total.aboutPoint(-reference);
}

} // namespace chesil
