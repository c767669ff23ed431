#include "core/contact/linearLaw.hpp"

#include "core/contact/contactForce.hpp"
#include "core/contact/restitution.hpp"

#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;

namespace
{

constexpr double stiffness = 1e6;

/// One dimension, two bodies: what a collision leaves of the approach velocity. Kick-drift-kick as the world
/// does it, with `steps` steps in half a period.
double reboundOf(double dampingRatio, double mass1, double mass2, int steps)
{
    LinearLaw law;
    law.normalStiffness = stiffness;
    law.dampingRatio = dampingRatio;
    const double effectiveMass = mass1 * mass2 / (mass1 + mass2);
    const double timeStep = M_PI * std::sqrt(effectiveMass / stiffness) / steps;
    double overlap = 0;
    double velocity1 = 0.75;
    double velocity2 = -0.25;
    double force = 0;
    for (int i = 0; i == 0 || overlap > 0; ++i)
    {
        velocity1 -= timeStep / 2 * force / mass1;
        velocity2 += timeStep / 2 * force / mass2;
        overlap += timeStep * (velocity1 - velocity2);
        const ContactState<2> state{overlap, Vector2(1, 0), Vector2(velocity1 - velocity2, 0), 1 / effectiveMass};
        force = overlap > 0 ? -contactForce<LinearLaw, 2>(law, state, timeStep, nullptr).force.x() : 0;
        velocity1 -= timeStep / 2 * force / mass1;
        velocity2 += timeStep / 2 * force / mass2;
        if (i > 1000 * steps)
        {
            return -1; // stuck
        }
    }
    EXPECT_NEAR(mass1 * velocity1 + mass2 * velocity2, 0.75 * mass1 - 0.25 * mass2, 1e-12);
    return velocity2 - velocity1;
}

LinearLaw frictional(double friction)
{
    LinearLaw law;
    law.normalStiffness = stiffness;
    law.tangentialStiffness = 0.5 * stiffness;
    law.friction = friction;
    return law;
}

} // namespace

TEST(LinearLaw, twoBodiesReboundWithTheWantedRestitution)
{
    for (const double wanted : {1.0, 0.95, 0.9, 0.7, 0.5, 0.3, 0.2, 0.1})
    {
        const double ratio = dampingRatioOf(wanted);
        EXPECT_NEAR(reboundOf(ratio, 1, 1, 4000), wanted, 1e-3) << wanted;
        EXPECT_NEAR(reboundOf(ratio, 0.01, 3, 4000), wanted, 1e-3) << wanted;
    }
}

TEST(LinearLaw, restitutionAndDampingRatioAreInverse)
{
    EXPECT_EQ(dampingRatioOf(1), 0);
    EXPECT_EQ(restitutionOf(0), 1);
    for (double wanted = 1; wanted > 1e-4; wanted *= 0.8)
    {
        EXPECT_NEAR(restitutionOf(dampingRatioOf(wanted)) / wanted, 1, 1e-9) << wanted;
    }
    // Both branches meet at critical damping.
    EXPECT_NEAR(restitutionOf(1 - 1e-6), std::exp(-2.0), 1e-6);
    EXPECT_NEAR(restitutionOf(1 + 1e-6), std::exp(-2.0), 1e-6);
}

TEST(LinearLaw, normalForceIsTheSpringsAndNeverAttracts)
{
    LinearLaw law;
    law.normalStiffness = stiffness;
    law.dampingRatio = 0.5;
    test::RandomSource random(111);
    for (int i = 0; i < 1000; ++i)
    {
        const Vector2 normal = random.direction();
        const Vector2 velocity = random.logUniform(1e-6, 1e2) * random.direction();
        const ContactState<2> state{random.logUniform(1e-12, 1e-3), normal, velocity, 1 / 0.3};
        const double damping = 2 * 0.5 * std::sqrt(0.3 * stiffness);
        const Vector2 force = contactForce<LinearLaw, 2>(law, state, 0, nullptr).force;
        const double expected = std::max(0.0, stiffness * state.depth + damping * velocity.dot(normal));
        EXPECT_NEAR(force.dot(normal), -expected, 1e-12 * (expected + 1));
        EXPECT_NEAR(cross(force, normal), 0, 1e-12 * (expected + 1));
    }
}

TEST(LinearLaw, frictionIsElasticUpToCoulombsLimitAndSlidesThere)
{
    const LinearLaw law = frictional(0.4);
    const double depth = 1e-5;
    const double limit = 0.4 * stiffness * depth;
    double spring = 0;
    const double timeStep = 1e-4;
    const double speed = 1e-3;
    double slipped = 0;
    for (int i = 0; i < 1000; ++i)
    {
        const ContactState<2> state{depth, Vector2(0, 1), Vector2(speed, 0), 1};
        const Vector2 force = contactForce(law, state, timeStep, &spring).force;
        slipped += speed * timeStep;
        const double expected = std::min(limit, law.tangentialStiffness * slipped);
        ASSERT_NEAR(force.x(), -expected, 1e-12 * limit) << "step " << i;
        ASSERT_NEAR(force.y(), -stiffness * depth, 1e-12 * limit);
    }
    // Having slid, it unloads elastically: back by half of the spring leaves half of the force.
    const double half = limit / law.tangentialStiffness / 2;
    const ContactState<2> back{depth, Vector2(0, 1), Vector2(-half / timeStep, 0), 1};
    EXPECT_NEAR(contactForce(law, back, timeStep, &spring).force.x(), -limit / 2, 1e-9 * limit);
}

TEST(LinearLaw, coulombsLimitHoldsWhateverTheState)
{
    LinearLaw law = frictional(0.3);
    law.dampingRatio = 0.2;
    test::RandomSource random(112);
    for (int i = 0; i < 2000; ++i)
    {
        const Vector2 normal = random.direction();
        double spring = random.uniform(-1, 1) * random.logUniform(1e-9, 1e-3);
        const ContactState<2> state{random.logUniform(1e-9, 1e-3), normal,
                                    random.logUniform(1e-6, 1) * random.direction(), 1 / 0.7};
        const double before = std::abs(spring);
        const Vector2 force = contactForce(law, state, 1e-5, &spring).force;
        const double normalForce = -force.dot(normal);
        EXPECT_GE(normalForce, 0);
        EXPECT_LE(std::abs(cross(normal, force)), 0.3 * normalForce * (1 + 1e-12) + 1e-15);
        // What sticks, the spring and the dashpot hold. What slips leaves a spring that friction holds alone, and none
        // that the dashpot has lengthened.
        const double damping = 2 * 0.2 * std::sqrt(0.7 * law.tangentialStiffness);
        const Vector2 slip = state.relativeVelocity - state.relativeVelocity.dot(normal) * normal;
        const Vector2 tangential = force + normalForce * normal;
        if (tangential.norm() < 0.3 * normalForce * (1 - 1e-9))
        {
            EXPECT_LT((tangential + law.tangentialStiffness * spring * perpendicular(normal) + damping * slip).norm(),
                      1e-10 * (1 + damping));
        }
        else
        {
            EXPECT_LE(law.tangentialStiffness * std::abs(spring), 0.3 * normalForce * (1 + 1e-9) + 1e-15);
        }
        EXPECT_LE(std::abs(spring), before + 1e-5 * slip.norm() + 1e-15);
    }
}

TEST(LinearLaw, theSpringTurnsWithTheContactAndKeepsItsLength)
{
    const LinearLaw law = frictional(1e3);
    test::RandomSource random(113);
    double angle = 0.3;
    double spring = 1e-6;
    for (int i = 0; i < 1000; ++i)
    {
        angle += random.uniform(-0.5, 0.5);
        const Vector2 normal(std::cos(angle), std::sin(angle));
        const Vector2 force = contactForce(law, ContactState<2>{1e-5, normal, Vector2::Zero(), 1}, 1e-5, &spring).force;
        ASSERT_EQ(spring, 1e-6);
        ASSERT_NEAR(cross(normal, force), -law.tangentialStiffness * 1e-6, law.tangentialStiffness * 1e-6 * 1e-12);
    }
}

TEST(LinearLaw, aBlockOnAnInclineSticksBelowTheFrictionAngleAndSlidesAbove)
{
    // Gravity turned instead of the plane; the block does not turn.
    const double friction = 0.5;
    const LinearLaw law = frictional(friction);
    const double mass = 2;
    const double timeStep = 1e-5;
    const auto slideAfter = [&](double incline, double time)
    {
        const Vector2 weight = 9.81 * mass * Vector2(std::sin(incline), -std::cos(incline));
        const Vector2 normal(0, -1);
        Vector2 position(0, -9.81 * mass * std::cos(incline) / stiffness);
        Vector2 velocity = Vector2::Zero();
        double spring = 0;
        Vector2 force = Vector2::Zero();
        const int steps = static_cast<int>(time / timeStep);
        for (int i = 0; i < steps; ++i)
        {
            velocity += timeStep / 2 / mass * force;
            position += timeStep * velocity;
            force = weight + contactForce(law, ContactState<2>{-position.y(), normal, velocity, 1 / mass},
                                          timeStep, &spring).force;
            velocity += timeStep / 2 / mass * force;
        }
        return position.x();
    };
    const double angle = std::atan(friction);
    // Stuck: the tangential spring oscillates about its rest by its own length (never damped here).
    const double elastic = 9.81 * mass * std::sin(0.9 * angle) / law.tangentialStiffness;
    EXPECT_LE(std::abs(slideAfter(0.7 * angle, 1.0)), 2 * elastic);
    // Sliding: x0 + v0 t + g (sin - mu cos) t^2/2, where v0 is what it gains before the spring has its full
    // force.
    for (const double incline : {1.2 * angle, 1.5 * angle})
    {
        const double acceleration = 9.81 * (std::sin(incline) - friction * std::cos(incline));
        EXPECT_NEAR((slideAfter(incline, 1.0) - 2 * slideAfter(incline, 0.5)) / (acceleration / 4), 1, 1e-3);
    }
}
