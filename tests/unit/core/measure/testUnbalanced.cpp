#include "core/measure/unbalanced.hpp"

#include "core/base/setupError.hpp"
#include "unit/core/measure/contactScenes.hpp"

#include <gtest/gtest.h>

using namespace chesil;
using namespace chesil::test;

TEST(Unbalanced, largestAndMean)
{
    ContactScene scene;
    scene.add(0, 1, Vector2(1, 0), Vector2(6, 8));
    scene.add(0, -1, Vector2(0, 1), Vector2(0, 30));
    scene.add(1, 2, Vector2(0, 1), Vector2(0, 100));
    scene.contacts[2].depth = 0;
    const std::optional<UnbalancedForce> found =
        unbalancedForce({Vector2(3, 4), Vector2(0, -1), Vector2(50, 0)}, {1, 2, 0}, scene.contacts);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->largest, 5.0 / 20);
    EXPECT_EQ(found->mean, 3.0 / 20);
}

TEST(Unbalanced, sameInATurnedScene)
{
    const ContactScene scene = turned(squareLattice(2, 2, 1, Vector2(3, 1), Vector2(1, 2)), 0.7);
    const Rotation<2> rotation(0.7);
    const std::vector<Vector2> forces{rotation.apply(Vector2(1, 2)), rotation.apply(Vector2(-0.5, 0))};
    const std::optional<UnbalancedForce> found = unbalancedForce(forces, {1, 1}, scene.contacts);
    const double contactForce = (std::sqrt(10) + std::sqrt(5)) / 2;
    EXPECT_DOUBLE_EQ(found.value().largest, std::sqrt(5) / contactForce);
    EXPECT_DOUBLE_EQ(found.value().mean, (std::sqrt(5) + 0.5) / 2 / contactForce);
}

TEST(Unbalanced, zeroInBalance)
{
    const ContactScene scene = squareLattice(2, 2, 1, Vector2(3, 0), Vector2(0, 2));
    const std::optional<UnbalancedForce> found =
        unbalancedForce(std::vector<Vector2>(4, Vector2(0, 0)), std::vector<double>(4, 1), scene.contacts);
    EXPECT_EQ(found.value().largest, 0);
    EXPECT_EQ(found.value().mean, 0);
}

TEST(Unbalanced, nothingToCompareWith)
{
    EXPECT_FALSE(unbalancedForce({Vector2(1, 0)}, {1}, {}));
    const ContactScene scene = squareLattice(2, 1, 1, Vector2(3, 0), Vector2(0, 2));
    EXPECT_FALSE(unbalancedForce({Vector2(1, 0)}, {0}, scene.contacts));
    EXPECT_FALSE(unbalancedForce({}, {}, scene.contacts));
    const ContactScene forceless = squareLattice(2, 1, 1, Vector2(0, 0), Vector2(0, 0));
    EXPECT_FALSE(unbalancedForce({Vector2(1, 0)}, {1}, forceless.contacts));
}

TEST(Unbalanced, refusesArraysOfDifferentLength)
{
    EXPECT_THROW(unbalancedForce({Vector2(1, 0)}, {}, {}), ValueError);
}
