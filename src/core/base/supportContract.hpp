#pragma once

#include "core/base/vector.hpp"

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace chesil
{

/// Radius of curvature of an outline at a normal, with its derivatives by the normal's angle, counter-clockwise [m, m/rad,
/// m/rad^2]. All 0 at a corner; an infinite value within a straight side, where the derivatives say nothing.
struct CurvatureRadius
{
    double value = 0;
    double first = 0;
    double second = 0;

    CurvatureRadius operator+(const CurvatureRadius& other) const
    {
        return {value + other.value, first + other.first, second + other.second};
    }
};

/// A support point and how the outline bends there. The grain's frame.
template <int Dim>
struct CurvedPoint
{
    Vector<Dim> point;
    CurvatureRadius radius;
    /// How far the normal may turn either way [rad, to first order] before the outline is another curve, or a straight
    /// side; 0 says nothing.
    double room;
};

/// A straight side of an outline, from start to end counter-clockwise [m]. The grain's frame.
struct StraightSide
{
    /// Outward, unit.
    Vector2 normal;
    Vector2 start;
    Vector2 end;
};

/// Which pieces of two outlines held the support points last: where to look first. Any value is safe.
struct PieceGuess
{
    std::uint8_t onA = 0;
    std::uint8_t onB = 0;

    /// Pieces beyond the 256th are not worth a byte more in each pair: they are not remembered.
    static PieceGuess of(std::size_t onA, std::size_t onB) { return {remembered(onA), remembered(onB)}; }

private:
    static std::uint8_t remembered(std::size_t piece) { return piece <= 255 ? static_cast<std::uint8_t>(piece) : std::uint8_t{0}; }
};

/// What GJK and EPA ask of a shape: support(direction), boundingRadius(). What the search for the nearest valley
/// asks beyond that (a shape without it is left to GJK and EPA):
///
/// - curvedSupport(normal): CurvedPoint for a unit normal;
/// - leastRadiusBetween(first, last): lower bound of the radius of curvature [m] between two normals, last less than half
///   a turn counter-clockwise of first; the tighter, the fewer splits a sweep over all directions takes;
/// - leastRadius(): lower bound of the radius of curvature of the whole outline [m], 0 if there are corners;
/// - innerRadius(): lower bound of the distance of the outline from the origin [m];
/// - mayHaveStraightSides, and if true hasStraightSides(); straightSideFacing(normal): pointer to the one whose
///   normal is nearest, null if there is none; straightSideBetween(from, to): pointer to one whose normal lies within
///   the turn of less than 180 degrees, either way, from one normal to the other (both excluded by
///   tolerances::sameNormal), the middle one of many, null if there is none.
///
/// Optional: an outline cut into parts, counter-clockwise, each with a range of normals of its own of less than half a
/// turn: partAt(normal), partAfter(i), partBefore(i), partStart(i) its first normal, partRadius(i) a lower bound of its radius of
/// curvature [m].
///
/// Optional, for pairs of two such shapes: curvedSupports(a, b, x, y, guess), curvedSupport of two grains side by side.
template <class ShapeType, class = void>
struct OffersCurvature : std::false_type
{
};

template <class ShapeType>
struct OffersCurvature<ShapeType, std::void_t<decltype(std::declval<const ShapeType&>().leastRadius())>> : std::true_type
{
};

template <class ShapeType, class = void>
struct OffersParts : std::false_type
{
};

template <class ShapeType>
struct OffersParts<ShapeType, std::void_t<decltype(&ShapeType::partAt)>> : std::true_type
{
};

template <class ShapeType, class = void>
struct OffersPairedSupport : std::false_type
{
};

template <class ShapeType>
struct OffersPairedSupport<ShapeType, std::void_t<decltype(&ShapeType::curvedSupports)>> : std::true_type
{
};

} // namespace chesil
