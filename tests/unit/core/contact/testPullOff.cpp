#include "core/contact/contactForce.hpp"
#include "core/contact/hertzMindlinLaw.hpp"
#include "core/measure/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;

// The attraction of Derjaguin, Muller & Toporov (1975) on top of Hertz's force. Closed forms: doc/contactLaws.md.

namespace
{

constexpr double radius = 1e-3;
constexpr double mass = 1e-5;

HertzMindlinLaw stickyLaw()
{
    HertzMindlinLaw law;
    law.effectiveModulus = 1e7;
    law.effectiveShearModulus = 1e7;
    law.workOfAdhesion = 0.1;
    return law;
}

double pullOff(const HertzMindlinLaw& law)
{
    return 2 * M_PI * law.workOfAdhesion * radius;
}

/// Of a sphere that arrives without speed and loses nothing: where (8/15) E sqrt(R) d^(5/2) = F d.
double deepest(const HertzMindlinLaw& law)
{
    return std::pow(15 * pullOff(law) / (8 * law.effectiveModulus * std::sqrt(radius)), 2.0 / 3.0);
}

double forceAt(const HertzMindlinLaw& law, double depth)
{
    const ContactState<2> state{depth, Vector2(0, -1), Vector2::Zero(), 1 / mass, radius, depth};
    return contactForce(law, state, 0, static_cast<double*>(nullptr)).force.y();
}

struct Flight
{
    bool sticks = false;
    double deepest = 0;
    /// Speed away from the plane at the end [m/s].
    double speed = 0;
};

/// Of a sphere that meets a plane at `speed` and is pulled away from it by `pull` [N]; it sticks if it turns round again.
Flight flightOf(const HertzMindlinLaw& law, double speed, double pull, double timeStep)
{
    Flight flight;
    double depth = 0;
    double inwards = speed;
    double force = 0;
    for (int turns = 0;;)
    {
        inwards += timeStep / 2 * (force - pull) / mass;
        const double before = depth;
        depth += timeStep * inwards;
        if (depth <= 0)
        {
            flight.speed = -inwards;
            return flight;
        }
        const ContactState<2> state{depth, Vector2(0, -1), Vector2(0, -inwards), 1 / mass, radius, before};
        force = -contactForce(law, state, timeStep, static_cast<double*>(nullptr)).force.y();
        const double middle = inwards;
        inwards += timeStep / 2 * (force - pull) / mass;
        turns += (middle > 0) != (inwards > 0);
        flight.deepest = std::max(flight.deepest, depth);
        if (turns == 2)
        {
            flight.sticks = true;
            return flight;
        }
    }
}

double timeScale(const HertzMindlinLaw& law)
{
    return std::sqrt(mass * deepest(law) / pullOff(law));
}

} // namespace

TEST(PullOff, isTwoPiWRWhateverTheStiffness)
{
    // Of half as much where two such spheres meet each other: R = radius/2.
    HertzMindlinLaw law = stickyLaw();
    for (const double modulus : {1e5, 1e7, 1e10})
    {
        law.effectiveModulus = modulus;
        EXPECT_NEAR(forceAt(law, 1e-30) / -6.283185307179586e-4, 1, 1e-12);
        // In balance without a load at d^(3/2) = 3 F/(4 E sqrt(R)).
        const double balance = std::pow(0.75 * pullOff(law) / (modulus * std::sqrt(radius)), 2.0 / 3.0);
        EXPECT_NEAR(forceAt(law, balance) / pullOff(law), 0, 1e-12);
        EXPECT_GT(forceAt(law, 1.1 * balance), 0);
    }
}

TEST(PullOff, aSlowPullBelowItHoldsAndOneAboveItDoesNot)
{
    HertzMindlinLaw law = stickyLaw();
    law.dampingRatio = 0.3;
    for (const double share : {0.99, 1.01})
    {
        // Raised in steps so slow that the sphere follows, from its place of balance.
        double depth = deepest(law) * std::pow(0.4, 2.0 / 3.0);
        double inwards = 0;
        const double timeStep = timeScale(law) / 100;
        const int steps = 400000;
        for (int i = 0; i < 2 * steps && depth > 0; ++i)
        {
            const double pull = share * pullOff(law) * std::min(1.0, i / static_cast<double>(steps));
            const ContactState<2> state{depth, Vector2(0, -1), Vector2(0, -inwards), 1 / mass, radius, depth};
            inwards += timeStep * (-contactForce(law, state, timeStep, static_cast<double*>(nullptr)).force.y() - pull) / mass;
            depth += timeStep * inwards;
        }
        EXPECT_EQ(depth > 0, share < 1) << share;
    }
}

TEST(PullOff, whatComesWithoutLossGoesAsFast)
{
    // The attraction begins and ends with the contact: no loss of its own, no sticking.
    const HertzMindlinLaw law = stickyLaw();
    const double slow = 1e-3 * std::sqrt(2 * pullOff(law) * deepest(law) / mass);
    const Flight flight = flightOf(law, slow, 0, timeScale(law) / 20000);
    EXPECT_FALSE(flight.sticks);
    EXPECT_NEAR(flight.deepest / deepest(law), 1, 1e-5);
    // (1/2) m v^2 + F d = (8/15) E sqrt(R) d^(5/2) at any speed.
    const double fast = 3 * std::sqrt(2 * pullOff(law) * deepest(law) / mass);
    const Flight impact = flightOf(law, fast, 0, timeScale(law) / 20000);
    const double d = impact.deepest;
    const double hertz = 8.0 / 15.0 * law.effectiveModulus * std::sqrt(radius) * std::pow(d, 2.5);
    EXPECT_NEAR((0.5 * mass * fast * fast + pullOff(law) * d) / hertz, 1, 1e-5);
    EXPECT_NEAR(impact.speed / fast, 1, 1e-4);
}

TEST(PullOff, sticksBelowTheSpeedThatTheDashpotsTake)
{
    // v^2 = (40/3) B(7/6, 3/2) z F d_m/m for a small damping ratio z.
    const double beta = std::tgamma(7.0 / 6.0) * std::tgamma(1.5) / std::tgamma(7.0 / 6.0 + 1.5);
    double before = 1;
    for (const double dampingRatio : {1e-2, 1e-3, 1e-4})
    {
        HertzMindlinLaw law = stickyLaw();
        law.dampingRatio = dampingRatio;
        const double expected = std::sqrt(40.0 / 3.0 * beta * dampingRatio * pullOff(law) * deepest(law) / mass);
        double sticks = 0;
        double leaves = 3 * expected;
        while (leaves - sticks > 1e-4 * expected)
        {
            const double middle = 0.5 * (sticks + leaves);
            (flightOf(law, middle, 0, timeScale(law) / 20000).sticks ? sticks : leaves) = middle;
        }
        const double error = std::abs(sticks / expected - 1);
        std::printf("damping ratio %g: sticks below %g m/s, %g of the closed form\n", dampingRatio, sticks, sticks / expected);
        EXPECT_LT(error, 20 * dampingRatio + 1e-3);
        EXPECT_LT(error, before) << "falls with the damping";
        before = error;
    }
}

TEST(PullOff, itsEnergyIsItsForceTimesTheDepth)
{
    const HertzMindlinLaw law = stickyLaw();
    const ContactState<2> state{2e-6, Vector2(0, -1), Vector2::Zero(), 1 / mass, radius, 2e-6};
    HertzMindlinLaw dry = law;
    dry.workOfAdhesion = 0;
    EXPECT_NEAR(elasticEnergy(law, state, 0.0) - elasticEnergy(dry, state, 0.0), -pullOff(law) * 2e-6, 1e-18);
}
