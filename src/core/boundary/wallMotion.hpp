#pragma once

#include "core/base/vector.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>

namespace chesil
{

/// A wall that keeps its place.
struct FixedWall
{
};

/// A wall that moves by law: x(t) = velocity t + amplitude sin(2 pi frequency t).
struct DrivenWall
{
    /// [m/s].
    Vector2 velocity = Vector2::Zero();
    /// [m], [1/s].
    Vector2 amplitude = Vector2::Zero();
    double frequency = 0;

    /// Over the interval from `time` on [s]: what carries the wall exactly to where the law has it at its end [m/s].
    Vector2 velocityOver(double time, double interval) const
    {
        const double turns = 2 * M_PI * frequency;
        const double swing = std::sin(turns * (time + interval)) - std::sin(turns * time);
        return velocity + swing / interval * amplitude;
    }
};

/// A wall that moves along its normal until the grains press on it with a given pressure.
struct ServoWall
{
    static constexpr std::size_t noWall = std::numeric_limits<std::size_t>::max();

    /// Compression positive [Pa].
    double pressure = 0;
    /// Largest speed [m/s] > 0.
    double speed = 0;
    /// The pressed length is the distance of these two walls along this one; indices.
    std::size_t between[2] = {noWall, noWall};

    /// Speed along the normal, into the domain [m/s], from the force by which the grains press on the wall, the one
    /// wanted [N], and the resistance of all its contacts, stiffness times time step plus damping [N s/m]; 0: no contact.
    /// From speed v to v' the force changes by at most (k dt + c) v' - c v, since the grains behind give way, too. With
    /// half of the difference in a step the error e follows e'' = e'/2 + b e/2, b = c/(k dt + c) < 1: it falls
    /// whatever the stiffness, the damping and the number of contacts.
    double speedFor(double force, double wanted, double resistance) const
    {
        constexpr double share = 0.5;
        if (!(resistance > 0))
        {
            return wanted > 0 ? speed : 0;
        }
        return std::max(-speed, std::min(share * (wanted - force) / resistance, speed));
    }
};

/// A wall that takes its half of a strain between it and a wall that faces it, of the distance that they have at the time.
struct ClosingWall
{
    /// Of the logarithmic strain, positive where the two approach [1/s].
    double strainRate = 0;
    /// The wall that faces it; index.
    std::size_t opposite = ServoWall::noWall;

    /// Along the normal, into the domain [m/s]: if both move so, their distance [m] decays exactly over the interval [s].
    double speedOver(double distance, double interval) const
    {
        return -distance * std::expm1(-strainRate * interval) / (2 * interval);
    }
};

using WallMotion = std::variant<FixedWall, DrivenWall, ServoWall, ClosingWall>;

inline bool moves(const WallMotion& motion)
{
    return !std::holds_alternative<FixedWall>(motion);
}

} // namespace chesil
