#pragma once

#include "core/geometry/outline.hpp"
#include "coupling/cellView/cellView.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

/// Areas of overlap by other means than the code under test, in long double.
namespace chesil::test
{

/// A point as a complex number.
using LongPoint = std::complex<long double>;
using LongPolygon = std::vector<LongPoint>;

inline LongPoint longPoint(const Vector2& p) { return {p.x(), p.y()}; }

inline long double longCross(const LongPoint& a, const LongPoint& b) { return (std::conj(a) * b).imag(); }

/// Relative to `origin`.
inline LongPolygon longPolygon(const CellPolygon& cell, const Vector2& origin)
{
    LongPolygon polygon;
    for (const Vector2& corner : cell)
    {
        polygon.push_back(longPoint(corner) - longPoint(origin));
    }
    return polygon;
}

inline long double polygonArea(const LongPolygon& polygon)
{
    long double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        doubled += longCross(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    return doubled / 2;
}

/// Integral of the position over a polygon.
inline LongPoint polygonFirstMoment(const LongPolygon& polygon)
{
    LongPoint sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const LongPoint& a = polygon[i];
        const LongPoint& b = polygon[(i + 1) % polygon.size()];
        sum += (a + b) * (longCross(a, b) / 6);
    }
    return sum;
}

/// Sutherland-Hodgman on points.
inline LongPolygon clipped(const LongPolygon& subject, const LongPolygon& by)
{
    LongPolygon result = subject;
    for (std::size_t k = 0; k < by.size(); ++k)
    {
        const LongPoint along = by[(k + 1) % by.size()] - by[k];
        LongPolygon kept;
        for (std::size_t i = 0; i < result.size(); ++i)
        {
            const LongPoint& a = result[i];
            const LongPoint& b = result[(i + 1) % result.size()];
            const long double da = longCross(along, a - by[k]);
            const long double db = longCross(along, b - by[k]);
            if (da >= 0)
            {
                kept.push_back(a);
            }
            if ((da >= 0) != (db >= 0))
            {
                kept.push_back(a + (b - a) * (da / (da - db)));
            }
        }
        result.swap(kept);
    }
    return result;
}

/// Many points on the outline about the grain's centre, turned by `angle` [rad]; `count` to a segment and
/// ten times as many to an arc.
inline LongPolygon finePolygon(const Outline& outline, double angle, int count)
{
    LongPolygon points;
    const LongPoint turn = std::polar(1.0L, static_cast<long double>(angle));
    for (const OutlinePiece& piece : outline)
    {
        if (const auto* arc = std::get_if<EllipticArc>(&piece))
        {
            for (int i = 0; i < 10 * count; ++i)
            {
                const long double a =
                    arc->from + (static_cast<long double>(arc->to) - arc->from) * i / (10 * count);
                points.push_back(turn * (longPoint(arc->centre) + std::cos(a) * longPoint(arc->axisA) +
                                         std::sin(a) * longPoint(arc->axisB)));
            }
            continue;
        }
        const auto& p = std::get<CubicBezier>(piece).controlPoints();
        for (int i = 0; i < count; ++i)
        {
            const long double t = static_cast<long double>(i) / count;
            const long double s = 1 - t;
            points.push_back(turn * (s * s * s * longPoint(p[0]) + 3 * s * s * t * longPoint(p[1]) +
                                     3 * s * t * t * longPoint(p[2]) + t * t * t * longPoint(p[3])));
        }
    }
    return points;
}

/// Area of a polygon's part in the unit disk, by the triangles that its edges span with the origin: an edge's
/// part inside the disk gives a triangle, its parts outside give sectors.
inline long double areaInUnitDisk(const LongPolygon& polygon)
{
    const auto sector = [](const LongPoint& a, const LongPoint& b) { return std::arg(b / a) / 2; };
    long double area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const LongPoint a = polygon[i];
        const LongPoint along = polygon[(i + 1) % polygon.size()] - a;
        const long double length = std::abs(along);
        const LongPoint unit = along / length;
        const long double foot = -(std::conj(unit) * a).real();
        const long double height = longCross(unit, -a);
        if (std::abs(height) >= 1)
        {
            area += sector(a, a + along);
            continue;
        }
        const long double reach = std::sqrt(1 - height * height);
        const long double enter = std::min(std::max(foot - reach, 0.0L), length);
        const long double leave = std::min(std::max(foot + reach, 0.0L), length);
        const LongPoint p = a + unit * enter;
        const LongPoint q = a + unit * leave;
        if (enter > 0)
        {
            area += sector(a, p);
        }
        area += longCross(p, q) / 2;
        if (leave < length)
        {
            area += sector(q, a + along);
        }
    }
    return area;
}

/// Area of a cell's part in an ellipse with half-axes a, b [m] and this pose: the affine map to the unit
/// disk.
inline long double areaInEllipse(const CellPolygon& cell, double a, double b, const Pose<2>& pose)
{
    LongPolygon polygon;
    for (const LongPoint& corner : longPolygon(cell, pose.position))
    {
        const LongPoint local = corner * std::polar(1.0L, -static_cast<long double>(pose.rotation.angle()));
        polygon.emplace_back(local.real() / a, local.imag() / b);
    }
    return areaInUnitDisk(polygon) * a * b;
}

} // namespace chesil::test
