#include "coupling/geometry/regionMoments.hpp"

#include <cmath>

namespace chesil
{

namespace
{

/// x - sin(x), by its series where the difference would cancel.
double angleMinusSine(double x)
{
    if (std::abs(x) > 0.5)
    {
        return x - std::sin(x);
    }
    const double y = x * x;
    // Terms up to x^13/13!: the next one is 1e-17 of the first at x = 0.5.
    return x * y / 6 * (1 - y / 20 * (1 - y / 42 * (1 - y / 72 * (1 - y / 110 * (1 - y / 156)))));
}

} // namespace

RegionMoments sliverMoments(const CubicBezier& curve, double from, double to)
{
    const auto& p = curve.controlPoints();
    const double length = to - from;
    const Vector2 third = p[3] - p[0] + 3 * (p[1] - p[2]);
    const Vector2 c1 = length * curve.derivative(from);
    const Vector2 c2 = length * length / 2 * curve.secondDerivative(from);
    const Vector2 c3 = length * length * length * third;

    const double c12 = cross(c1, c2);
    const double c13 = cross(c1, c3);
    const double c23 = cross(c2, c3);
    RegionMoments moments;
    moments.area = (c12 / 3 + c13 / 2 + c23 / 5) / 2;
    moments.first = (c1 * (c12 / 4 + 2 * c13 / 5 + c23 / 6) + c2 * (c12 / 5 + c13 / 3 + c23 / 7) +
                     c3 * (c12 / 6 + 2 * c13 / 7 + c23 / 8)) /
                    3;
    return moments;
}

RegionMoments sliverMoments(const EllipticArc& arc, double from, double to, const Vector2& start)
{
    const double doubled = cross(arc.axisA, arc.axisB);
    const double half = (to - from) / 2;
    const double sine = std::sin(half);
    const double middle = from + half;
    const Vector2 outward = std::cos(middle) * arc.axisA + std::sin(middle) * arc.axisB;
    const RegionMoments aboutCentre{doubled / 2 * angleMinusSine(to - from),
                                    doubled * (2.0 / 3.0) * sine * sine * sine * outward};
    return aboutCentre.aboutPoint(start - arc.centre);
}

} // namespace chesil
