#include "core/dynamics/localDamping.hpp"

#include <gtest/gtest.h>

using namespace chesil;

TEST(LocalDamping, lowersWhatDrivesAndRaisesWhatBrakes)
{
    EXPECT_DOUBLE_EQ(locallyDamped(10, 1, 0.7), 3);
    EXPECT_DOUBLE_EQ(locallyDamped(-10, -1, 0.7), -3);
    EXPECT_DOUBLE_EQ(locallyDamped(10, -1, 0.7), 17);
    EXPECT_DOUBLE_EQ(locallyDamped(-10, 1, 0.7), -17);
}

TEST(LocalDamping, addsNothingAtRestOrWithoutForce)
{
    EXPECT_EQ(locallyDamped(10, 0, 0.7), 10);
    EXPECT_EQ(locallyDamped(0, 5, 0.7), 0);
    EXPECT_EQ(locallyDamped(0, 0, 0.7), 0);
}

TEST(LocalDamping, worksOnEachComponentAndTheTorque)
{
    Bodies<2> bodies;
    bodies.pose.resize(1);
    bodies.velocity = {Vector2(1, -1)};
    bodies.angularVelocity = {2};
    bodies.force = {Vector2(4, 4)};
    bodies.torque = {-8};
    dampLocally(bodies, 0.5, [](std::size_t) { return Vector2(0, 0); });
    EXPECT_EQ(bodies.force[0], Vector2(2, 6));
    EXPECT_EQ(bodies.torque[0], -12);
}

TEST(LocalDamping, takesPowerAwayWhateverTheSigns)
{
    for (const double force : {-2.0, -0.1, 0.3, 5.0})
    {
        for (const double velocity : {-3.0, -0.2, 0.4, 7.0})
        {
            EXPECT_LT(locallyDamped(force, velocity, 0.7) * velocity, force * velocity);
        }
    }
}
