#include "core/measure/energy.hpp"

#include "core/contact/hertzMindlinLaw.hpp"
#include "core/contact/linearLaw.hpp"

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

TEST(Energy, springsStoreWhatPushesThemIn)
{
    LinearLaw linear;
    linear.normalStiffness = 1e6;
    linear.tangentialStiffness = 1e5;
    ContactState<2> contact{1e-3, Vector2::UnitX(), Vector2::Zero(), 1};
    EXPECT_DOUBLE_EQ(elasticEnergy(linear, contact, -5e-4), 0.5 + 0.5 * 1e5 * 25e-8);

    HertzMindlinLaw hertz;
    hertz.effectiveModulus = 1e9;
    hertz.effectiveShearModulus = 4e8;
    contact.effectiveRadius = 0.02;
    double work = 0;
    constexpr int parts = 10000;
    for (int k = 0; k < parts; ++k)
    {
        ContactState<2> part = contact;
        part.depth = contact.depth * (k + 0.5) / parts;
        work += hertz.springs(part).normalForce * contact.depth / parts;
    }
    EXPECT_NEAR(elasticEnergy(hertz, contact, 0.0) / work, 1, 1e-7);
}
