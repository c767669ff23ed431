#include "core/measure/energy.hpp"

#include <gtest/gtest.h>

using namespace chesil;

TEST(Energy, kineticEnergyOfWhatMoves)
{
    Bodies<2> bodies;
    bodies.pose.resize(2);
    bodies.velocity = {Vector2(3, 4), Vector2(100, 0)};
    bodies.angularVelocity = {2, 100};
    bodies.inverseMass = {1 / 2.0, 0};
    bodies.inverseInertia = {1 / 8.0, 0};
    EXPECT_DOUBLE_EQ(kineticEnergy(bodies), 0.5 * 2 * 25 + 0.5 * 8 * 4);
}

TEST(Energy, contactEnergyOfWhatTouches)
{
    LinearLaw law;
    law.normalStiffness = 1e6;
    law.tangentialStiffness = 1e5;
    Contact<2> touching{0, 1};
    touching.depth = 1e-3;
    touching.spring = Vector2(3e-4, -4e-4);
    const Contact<2> apart{0, 2};
    EXPECT_DOUBLE_EQ(contactEnergy(law, {touching, apart}), 0.5 + 0.5 * 1e5 * 25e-8);
}
