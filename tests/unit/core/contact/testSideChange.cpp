#include "core/contact/sideChange.hpp"

#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

// A point that is pressed out of a corner through the nearer of its two sides, and passes from one to the other.

using namespace chesil;

namespace
{

/// Sides through the origin with these outward normals; the point (mass 1, stiffness 1) is inside.
struct Corner
{
    Vector2 first;
    Vector2 second;

    SideHeld<2> contact(const Vector2& point) const
    {
        const double ofFirst = -point.dot(first);
        const double ofSecond = -point.dot(second);
        // From the point, the first body, into the corner.
        return ofFirst < ofSecond ? SideHeld<2>{ofFirst, -first} : SideHeld<2>{ofSecond, -second};
    }
};

/// Growth of the energy as the point passes a corner, over the energy of the contact.
double growth(const Corner& corner, Vector2 point, Vector2 velocity, double timeStep, bool corrected)
{
    SideHeld<2> held = corner.contact(point);
    Vector2 force = -held.depth * held.normal;
    const auto energy = [&] { return velocity.squaredNorm() / 2 + held.depth * held.depth / 2; };
    const double before = energy();
    const double spring = held.depth * held.depth / 2;
    bool changed = false;
    for (int i = 0; i * timeStep < 0.4; ++i)
    {
        velocity += timeStep / 2 * force;
        point += timeStep * velocity;
        const SideHeld<2> now = corner.contact(point);
        force = -now.depth * now.normal;
        if (areOfTwoSides(held, now))
        {
            changed = true;
            if (corrected)
            {
                force += sideChange(held, now, velocity, now.depth, timeStep);
            }
        }
        velocity += timeStep / 2 * force;
        held = now;
    }
    EXPECT_TRUE(changed);
    return (energy() - before) / spring;
}

double rootMeanSquare(double timeStep, bool corrected)
{
    constexpr std::uint64_t seed = 20261123;
    test::RandomSource random(seed);
    constexpr int corners = 400;
    double sum = 0;
    for (int i = 0; i < corners; ++i)
    {
        const double half = random.uniform(0.4, 1.1);
        const Corner corner{Vector2(std::cos(half), std::sin(half)), Vector2(-std::cos(half), std::sin(half))};
        // On the bisector, where both sides are as near, after about 0.2 s.
        const Vector2 velocity(random.uniform(1, 2), random.uniform(-0.2, 0.2));
        const double error = growth(corner, Vector2(-0.2 * velocity.x(), -1), velocity, timeStep, corrected);
        sum += error * error;
    }
    return std::sqrt(sum / corners);
}

} // namespace

TEST(SideChange, errsByTheSquareOfTheStep)
{
    const double coarse = rootMeanSquare(1e-2, true);
    const double fine = rootMeanSquare(1e-3, true);
    EXPECT_GT(std::log10(coarse / fine), 1.8);
    // Without it the error goes with the step.
    EXPECT_GT(rootMeanSquare(1e-3, false), 50 * fine);
    EXPECT_LT(std::log10(rootMeanSquare(1e-2, false) / rootMeanSquare(1e-3, false)), 1.3);
}

TEST(SideChange, isNothingForANewContactOrOneSide)
{
    const Vector2 up(0, 1);
    const Vector2 aside(1, 0);
    EXPECT_FALSE(areOfTwoSides<2>({0, up}, {1e-3, aside})) << "just touched";
    EXPECT_FALSE(areOfTwoSides<2>({1e-3, up}, {0, aside})) << "released";
    EXPECT_FALSE(areOfTwoSides<2>({1e-3, up}, {1e-3, Vector2(std::sin(0.04), std::cos(0.04))})) << "turned";
    EXPECT_TRUE(areOfTwoSides<2>({1e-3, up}, {1e-3, aside}));
}

TEST(SideChange, isNothingWhereTheDepthDidNotTellThemApart)
{
    // The other side was nearer all along: another corner, say, that took over.
    const Vector2 none = sideChange<2>({1e-3, Vector2(0, 1)}, {2e-4, Vector2(1, 0)}, Vector2(1e-3, 1e-3), 1, 1e-3);
    EXPECT_EQ(none, Vector2(0, 0));
}

TEST(SideChange, isHalfOfTheDifferenceAtMost)
{
    const Vector2 up(0, 1);
    const Vector2 aside(1, 0);
    // Equal at the step's end: the whole step was the old side's, half of it has been given to the new one.
    const Vector2 change = sideChange<2>({1e-3, up}, {1e-3, aside}, Vector2(-1, 0), 2, 1e-3);
    EXPECT_LT((change - (aside - up)).norm(), 1e-12);
}
