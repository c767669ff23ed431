#include "core/dynamics/velocityVerlet.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;

namespace
{

/// One body on springs of frequency w [rad/s] for both translation and turn, started at 1 without velocity.
class Oscillator
{
public:
    explicit Oscillator(double frequency) : frequency_(frequency)
    {
        bodies_.pose.push_back({Vector2(1, 0), Rotation<2>(1)});
        bodies_.velocity.push_back(Vector2::Zero());
        bodies_.angularVelocity.push_back(0);
        bodies_.inverseMass.push_back(1 / mass);
        bodies_.inverseInertia.push_back(1 / inertia);
        bodies_.force.push_back(Vector2::Zero());
        bodies_.torque.push_back(0);
        pull();
    }

    void step(double timeStep)
    {
        kick(bodies_, timeStep / 2);
        drift(bodies_, timeStep);
        pull();
        kick(bodies_, timeStep / 2);
    }

    double x() const { return bodies_.pose[0].position.x(); }
    double angle() const { return bodies_.pose[0].rotation.angle(); }

private:
    static constexpr double mass = 3;
    static constexpr double inertia = 0.2;

    void pull()
    {
        bodies_.force[0] = -mass * frequency_ * frequency_ * bodies_.pose[0].position;
        bodies_.torque[0] = -inertia * frequency_ * frequency_ * bodies_.pose[0].rotation.angle();
    }

    double frequency_;
    Bodies<2> bodies_;
};

double errorAfterOnePeriod(int steps)
{
    constexpr double frequency = 7;
    Oscillator oscillator(frequency);
    // A quarter more, where the position changes fastest with the phase.
    for (int i = 0; i < steps * 5 / 4; ++i)
    {
        oscillator.step(2 * M_PI / frequency / steps);
    }
    EXPECT_NEAR(oscillator.x(), oscillator.angle(), 1e-12);
    return std::abs(oscillator.x());
}

double largestAfter(int steps, double timesFrequency)
{
    Oscillator oscillator(1);
    double largest = 0;
    for (int i = 0; i < steps; ++i)
    {
        oscillator.step(timesFrequency);
        largest = std::max(largest, std::abs(oscillator.x()));
    }
    return largest;
}

} // namespace

TEST(VelocityVerlet, isOfSecondOrder)
{
    for (const int steps : {100, 200, 400})
    {
        EXPECT_NEAR(std::log2(errorAfterOnePeriod(steps) / errorAfterOnePeriod(2 * steps)), 2, 0.01);
    }
}

TEST(VelocityVerlet, isStableJustBelowTwoOverTheFrequencyAndNotAbove)
{
    EXPECT_LT(largestAfter(100000, 2 * (1 - 1e-6)), 1e4);
    EXPECT_GT(largestAfter(100000, 2 * (1 + 1e-6)), 1e10);
}

TEST(VelocityVerlet, staysBoundedForever)
{
    // Symplectic: after 10^5 periods the amplitude is still 1 + O(h^2).
    EXPECT_LT(largestAfter(3000000, 0.2), 1.01);
}

TEST(VelocityVerlet, bodiesWithoutInverseMassKeepTheirVelocity)
{
    Bodies<2> bodies;
    bodies.pose.push_back({Vector2(0, 0), {}});
    bodies.velocity.push_back(Vector2(1, 2));
    bodies.angularVelocity.push_back(3);
    bodies.inverseMass.push_back(0);
    bodies.inverseInertia.push_back(0);
    bodies.force.push_back(Vector2(1e9, 1e9));
    bodies.torque.push_back(1e9);
    kick(bodies, 0.5);
    drift(bodies, 0.5);
    EXPECT_EQ(bodies.velocity[0], Vector2(1, 2));
    EXPECT_EQ(bodies.pose[0].position, Vector2(0.5, 1));
    EXPECT_EQ(bodies.pose[0].rotation.angle(), 1.5);
}
