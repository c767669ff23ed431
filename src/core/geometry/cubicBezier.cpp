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

Vector2 CubicBezier::at(double t) const
{
    const double s = 1 - t;
    return s * s * s * points_[0] + 3 * s * t * (s * points_[1] + t * points_[2]) + t * t * t * points_[3];
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
    const double rise0 = direction.dot(points_[1] - points_[0]);
    const double a1 = direction.dot(points_[2] - points_[1]);
    const double rise2 = direction.dot(points_[3] - points_[2]);
    if (rise0 <= 0 && rise2 >= 0)
    {
        // No root: beyond an end, or along a straight segment's normal.
        const double rise = rise0 + a1 + rise2;
        return rise > 0 ? 1.0 : rise < 0 ? 0.0 : 0.5;
    }
    const double a0 = std::max(0.0, rise0);
    const double a2 = std::min(0.0, rise2);
    const double root = std::sqrt(a1 * a1 - a0 * a2);
    if (a1 > 0)
    {
        return (a1 + root) / (a1 + root - a2);
    }
    return a0 > 0 ? a0 / (a0 - a1 + root) : 0.0;
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
