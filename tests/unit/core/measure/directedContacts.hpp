#pragma once

#include "unit/core/measure/contactScenes.hpp"
#include "unit/randomGrain.hpp"

#include <cmath>

/// Contacts whose directions and forces follow given Fourier series.
namespace chesil::test
{

/// E(t) = (1 + a cos 2(t - ta))/(2 pi), fn(t) = f0 (1 + an cos 2(t - tn)), ft(t) = -f0 at sin 2(t - tt).
struct DirectedForces
{
    double a, ta, f0, an, tn, at, tt;

    /// The direction below which the share u of all normals lies, from that of ta on.
    double direction(double u) const
    {
        double t = 2 * M_PI * u;
        double step = 1;
        for (int i = 0; i < 100 && std::abs(step) > 4e-15; ++i)
        {
            step = (t + 0.5 * a * std::sin(2 * t) - 2 * M_PI * u) / (1 + a * std::cos(2 * t));
            t -= step;
        }
        return ta + t;
    }

    double normal(double t) const { return f0 * (1 + an * std::cos(2 * (t - tn))); }
    double tangential(double t) const { return -f0 * at * std::sin(2 * (t - tt)); }

    void addTo(ContactScene& scene, double t, double normalShare, double tangentialShare) const
    {
        const Vector2 n(std::cos(t), std::sin(t));
        scene.add(0, 1, n, normalShare * normal(t) * n + tangentialShare * tangential(t) * perpendicular(n));
        scene.area = 1;
    }

    /// One contact for each of equal shares of E: sums over them are a trapezoidal rule for periodic
    /// functions, exact to rounding.
    ContactScene quadrature(int points) const
    {
        ContactScene scene;
        for (int i = 0; i < points; ++i)
        {
            addTo(scene, direction((i + 0.37) / points), 1, 1);
        }
        return scene;
    }

    /// Directions drawn from E, forces scattered by +-100 % about fn and ft.
    ContactScene drawn(int count, RandomSource& random) const
    {
        ContactScene scene;
        for (int i = 0; i < count; ++i)
        {
            const double t = direction(random.uniform(0, 1));
            const double normalShare = random.uniform(0, 2);
            addTo(scene, t, normalShare, random.uniform(0, 2));
        }
        return scene;
    }
};

} // namespace chesil::test
