#pragma once

#include "core/base/smallTurn.hpp"
#include "core/base/vector.hpp"

#include <cmath>

namespace chesil
{

template <int Dim>
class Rotation;

/// A turn in the plane by an angle [rad], counter-clockwise. Cosine and sine are kept, since every
/// support call needs them; the angle counts whole turns, too.
template <>
class Rotation<2>
{
public:
    Rotation() = default;

    explicit Rotation(double angle) : angle_(angle), cosine_(std::cos(angle)), sine_(std::sin(angle)) {}

    /// Goes on from what another one had; of unit length to rounding.
    Rotation(double angle, const Vector2& direction) : angle_(angle), cosine_(direction.x()), sine_(direction.y()) {}

    double angle() const { return angle_; }

    /// Where the grain's x axis points.
    Vector2 direction() const { return Vector2(cosine_, sine_); }

    /// Turns on by `increment` [rad]. What is rounded in direction() adds up like a random walk: 1e-16 times the root of
    /// the number of turns.
    void turn(double increment)
    {
        angle_ += increment;
        if (!(std::abs(increment) <= smallTurn))
        {
            *this = Rotation(angle_);
            return;
        }
        const Vector2 turned = turnedBy(increment, direction());
        const double correction = 1.5 - 0.5 * turned.squaredNorm();
        cosine_ = correction * turned.x();
        sine_ = correction * turned.y();
    }

    /// From the grain's frame to the world's.
    Vector2 apply(const Vector2& local) const
    {
        return Vector2(cosine_ * local.x() - sine_ * local.y(), sine_ * local.x() + cosine_ * local.y());
    }

    /// From the world's frame to the grain's.
    Vector2 applyInverse(const Vector2& world) const
    {
        return Vector2(cosine_ * world.x() + sine_ * world.y(), cosine_ * world.y() - sine_ * world.x());
    }

private:
    double angle_ = 0;
    double cosine_ = 1;
    double sine_ = 0;
};

/// Where a grain is: its centroid in the world [m] and its turn.
template <int Dim>
struct Pose
{
    Vector<Dim> position = Vector<Dim>::Zero();
    Rotation<Dim> rotation;

    Vector<Dim> toWorld(const Vector<Dim>& local) const { return position + rotation.apply(local); }

    Vector<Dim> toLocal(const Vector<Dim>& world) const { return rotation.applyInverse(world - position); }
};

} // namespace chesil
