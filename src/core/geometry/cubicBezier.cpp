#include "core/geometry/cubicBezier.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chesil
{

CubicBezier CubicBezier::straight(const Vector2& a, const Vector2& b)
{
    return CubicBezier({a, a + (b - a) / 3, b - (b - a) / 3, b});
}

Vector2 CubicBezier::derivative(double t) const
{
    const double s = 1 - t;
    return 3
        * (s * s * (points_[1] - points_[0]) + 2 * s * t * (points_[2] - points_[1])
           + t * t * (points_[3] - points_[2]));
}

Vector2 CubicBezier::secondDerivative(double t) const
{
    return 6
        * ((1 - t) * (points_[2] - 2 * points_[1] + points_[0]) + t * (points_[3] - 2 * points_[2] + points_[1]));
}

Vector2 CubicBezier::startTangent() const
{
    for (int i = 1; i < 4; ++i)
    {
        if (points_[i] != points_[0])
        {
            return points_[i] - points_[0];
        }
    }
    return Vector2::Zero();
}

Vector2 CubicBezier::endTangent() const
{
    for (int i = 2; i >= 0; --i)
    {
        if (points_[i] != points_[3])
        {
            return points_[3] - points_[i];
        }
    }
    return Vector2::Zero();
}

double CubicBezier::supportParameter(const Vector2& direction) const
{
    return supportParameterOfRises(
        direction.dot(points_[1] - points_[0]),
        direction.dot(points_[2] - points_[1]),
        direction.dot(points_[3] - points_[2]));
}

double CubicBezier::curvatureRadius(double t) const
{
    const Vector2 first = derivative(t);
    const double turning = cross(first, secondDerivative(t));
    const double speed = first.norm();
    if (turning == 0)
    {
        return std::numeric_limits<double>::infinity();
    }
    return speed * speed * speed / turning;
}

namespace
{

/// radius = 1.5 |u|^3/(u x v), where u = s^2 e0 + 2 s t e1 + t^2 e2 and u x v = s^2 e0 x e1 + s t e0 x e2 + t^2 e1 x e2
/// for the control edges e: bounded by their coefficients.
double curvatureRadiusBound(const CubicBezier& part)
{
    const auto& p = part.controlPoints();
    const Vector2 chord = p[3] - p[0];
    const std::array<Vector2, 3> edges{p[1] - p[0], p[2] - p[1], p[3] - p[2]};
    double slowest = std::numeric_limits<double>::infinity();
    for (const Vector2& edge : edges)
    {
        slowest = std::min(slowest, edge.dot(chord) / chord.norm());
    }
    const double bend = std::max({cross(edges[0], edges[1]), cross(edges[0], edges[2]) / 2, cross(edges[1], edges[2])});
    if (!(slowest > 0))
    {
        return 0;
    }
    return bend > 0 ? 1.5 * slowest * slowest * slowest / bend : std::numeric_limits<double>::infinity();
}

} // namespace

double CubicBezier::leastCurvatureRadius() const
{
    constexpr int parts = 16;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < parts; ++i)
    {
        least = std::min(least, curvatureRadiusBound(part(static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts)));
    }
    return least;
}

std::pair<CubicBezier, CubicBezier> CubicBezier::split(double t) const
{
    const auto between = [t](const Vector2& a, const Vector2& b) -> Vector2 { return a + t * (b - a); };
    const Vector2 a0 = between(points_[0], points_[1]);
    const Vector2 a1 = between(points_[1], points_[2]);
    const Vector2 a2 = between(points_[2], points_[3]);
    const Vector2 b0 = between(a0, a1);
    const Vector2 b1 = between(a1, a2);
    const Vector2 middle = between(b0, b1);
    return {CubicBezier({points_[0], a0, b0, middle}), CubicBezier({middle, b1, a2, points_[3]})};
}

CubicBezier CubicBezier::part(double t0, double t1) const
{
    const CubicBezier tail = t0 > 0 ? split(t0).second : *this;
    return t1 < 1 ? tail.split((t1 - t0) / (1 - t0)).first : tail;
}

CubicBezier CubicBezier::transformed(const Vector2& translation, double cosine, double sine, double scale) const
{
    CubicBezier result;
    for (int i = 0; i < 4; ++i)
    {
        const Vector2& p = points_[i];
        result.points_[i] =
            translation + scale * Vector2(cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y());
    }
    return result;
}

} // namespace chesil
