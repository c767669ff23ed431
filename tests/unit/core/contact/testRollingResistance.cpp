#include "core/contact/rollingResistance.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;

namespace
{

constexpr double friction = 0.2;
constexpr double radius = 0.01;
constexpr double pressing = 50;
constexpr double stiffness = 1e6;

double torqueAfter(double spin, double timeStep, double& turned)
{
    return rollingTorque(friction, radius, pressing, stiffness, spin, timeStep, turned);
}

} // namespace

TEST(RollingResistance, isElasticUpToItsLimitAndYieldsThere)
{
    const double spring = rollingStiffness * stiffness * friction * friction * radius * radius;
    const double limit = friction * radius * pressing;
    double turned = 0;
    EXPECT_DOUBLE_EQ(torqueAfter(1e-3, 0.1, turned), -spring * 1e-4);
    EXPECT_DOUBLE_EQ(torqueAfter(1e3, 0.1, turned), -limit);
    // Turning back unloads it elastically from there.
    const double back = limit / spring / 2;
    EXPECT_NEAR(torqueAfter(-back, 1, turned), -limit / 2, 1e-12 * limit);
}

TEST(RollingResistance, stopsARollingDiskAfterTheWayOfEnergy)
{
    // A disk that rolls without slip at v loses mu m g R a radian: it stops after (3/4) v^2/(mu g).
    constexpr double mass = 1;
    constexpr double weight = mass * 9.81;
    constexpr double timeStep = 1e-5;
    double speed = 1;
    double way = 0;
    double turned = 0;
    while (speed > 0)
    {
        const double torque = rollingTorque(friction, radius, weight, stiffness, -speed / radius, timeStep, turned);
        speed -= timeStep * torque / radius / (1.5 * mass);
        way += timeStep * speed;
    }
    EXPECT_NEAR(way, 0.75 / (friction * 9.81), 1e-3 * way);
}
