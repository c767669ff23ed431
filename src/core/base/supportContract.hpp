#pragma once

#include "core/base/vector.hpp"

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

/// A stretch of an outline, given by its range of outward normals (unit, counter-clockwise, less than
/// half a turn), on which the radius of curvature is nowhere below `leastRadius` [m]. The grain's frame.
struct OutlineStretch
{
    double leastRadius;
    /// The bound holds all round; the two normals say nothing then.
    bool whole;
    Vector2 firstNormal;
    Vector2 lastNormal;
};

/// A straight side of an outline, from start to end counter-clockwise [m]. The grain's frame.
struct StraightSide
{
    /// Outward, unit.
    Vector2 normal;
    Vector2 start;
    Vector2 end;
};

/// What GJK and EPA ask of a shape: support(direction), boundingRadius(). What the search for the nearest valley
/// asks beyond that (a shape without it is left to GJK and EPA):
///
/// - curvedSupport(normal): CurvedPoint for a unit normal;
/// - stretchAt(normal): an OutlineStretch that holds this normal;
/// - leastRadiusBetween(first, last): lower bound of the radius of curvature [m] between two normals, last less than half
///   a turn counter-clockwise of first; the tighter, the fewer splits a sweep over all directions takes;
/// - leastRadius(): lower bound of the radius of curvature of the whole outline [m], 0 if there are corners;
/// - innerRadius(): lower bound of the distance of the outline from the origin [m];
/// - mayHaveStraightSides, and if true hasStraightSides(); straightSideFacing(normal): pointer to the one whose
///   normal is nearest, null if there is none; straightSideBetween(from, to): pointer to one whose normal lies within
///   the turn of less than 180 degrees, either way, from one normal to the other (both excluded by
///   tolerances::sameNormal), the middle one of many, null if there is none.
///
/// Optional, for pairs of two such shapes: curvedSupports(a, b, x, y), curvedSupport of two grains side by side.
template <class ShapeType, class = void>
struct OffersCurvature : std::false_type
{
};

template <class ShapeType>
struct OffersCurvature<ShapeType, std::void_t<decltype(std::declval<const ShapeType&>().leastRadius())>> : std::true_type
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
