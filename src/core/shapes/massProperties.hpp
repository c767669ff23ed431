#pragma once

namespace chesil
{

/// Of a plane grain per unit depth, density not yet included: area [m2] and the integral of the squared
/// distance from the centroid [m4]. Mass = density * area, moment of inertia = density * polarMoment.
struct MassProperties
{
    double area = 0;
    double polarMoment = 0;
};

} // namespace chesil
