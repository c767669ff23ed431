#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

} // namespace

TEST(WorldContacts, momentumIsKeptWithoutWallsAndLoads)
{
    WorldSettings settings = test::mixedScene(40, 152);
    settings.walls.clear();
    settings.gravity = Vector2::Zero();
    settings.localDamping = 0;
    settings.linear().dampingRatio = 0.2;
    test::RandomSource random(153);
    for (GrainState& grain : settings.grains)
    {
        grain.velocity = random.uniform(0, 2) * random.direction();
        grain.angularVelocity = random.uniform(-20, 20);
    }
    World world(settings);
    const auto momenta = [&world]
    {
        const Bodies<2>& bodies = world.bodies();
        Vector2 linear = Vector2::Zero();
        double angular = 0;
        for (std::size_t i = 0; i < bodies.size(); ++i)
        {
            linear += bodies.velocity[i] / bodies.inverseMass[i];
            angular += cross(bodies.pose[i].position, bodies.velocity[i]) / bodies.inverseMass[i] +
                       bodies.angularVelocity[i] / bodies.inverseInertia[i];
        }
        return std::pair{linear, angular};
    };
    const auto [linear, angular] = momenta();
    const double timeStep = 0.2 * world.stableTimeStep();
    world.updateForces();
    int contacts = 0;
    for (int i = 0; i < 3000; ++i)
    {
        world.step(timeStep);
        contacts += world.largestRelativeOverlap() > 0 ? 1 : 0;
    }
    EXPECT_GT(contacts, 300);
    EXPECT_LT((momenta().first - linear).norm(), 1e-11 * 40 * 5.2);
    EXPECT_NEAR(momenta().second, angular, 1e-11 * 40 * 5.2);
}

TEST(WorldContacts, farFromTheOriginTheContactsAreAlike)
{
    // Coordinates are multiples of 2^-12 m, so that a shift by 1024 m is exact: only contact points are
    // rounded.
    const auto settledOn = [](const Vector2& shift)
    {
        WorldSettings settings = test::quartzSettings();
        settings.shapes = test::shapesOfEachKind(154);
        PlaneWall<2> floor = test::floorWall();
        floor.point += shift;
        settings.walls = {floor};
        test::RandomSource random(155);
        for (int i = 0; i < 64; ++i)
        {
            GrainState grain;
            grain.shape = i % 4;
            grain.position = shift + Vector2(random.integer(0, 1023), random.integer(60, 1023)) / 4096;
            grain.angle = random.uniform(-3, 3);
            settings.grains.push_back(grain);
        }
        World world(settings);
        world.updateForces();
        return world;
    };
    const Vector2 away(1024, -1024);
    const World here = settledOn(Vector2::Zero());
    const World there = settledOn(away);
    ASSERT_EQ(here.contacts().size(), there.contacts().size());
    int touching = 0;
    for (std::size_t i = 0; i < here.contacts().size(); ++i)
    {
        const Contact<2>& a = here.contacts()[i];
        const Contact<2>& b = there.contacts()[i];
        EXPECT_EQ(a.key(), b.key());
        // A wall's foot point is a world position, hence rounded at 1024 m; pairs know only their offset.
        const double rounding = a.withWall() ? 4 * 1024 * epsilon : 0;
        EXPECT_NEAR(a.depth, b.depth, rounding);
        EXPECT_EQ(a.normal, b.normal);
        if (a.depth > 0)
        {
            EXPECT_LT((a.point + away - b.point).norm(), 4 * 1024 * epsilon);
            ++touching;
        }
    }
    EXPECT_GT(touching, 100);
}

TEST(WorldContacts, whatComesFromAfarIsNotMissed)
{
    // Over many skins of the neighbour list to a resting ball, which flies on to a wall.
    WorldSettings settings = test::freeBall();
    settings.walls = {{"right", Vector2(3, 0), Vector2(-1, 0)}};
    settings.grains.push_back(settings.grains[0]);
    settings.grains[0].position = Vector2(-2, 0);
    settings.grains[0].velocity = Vector2(1, 0);
    World world(settings);
    const double timeStep = 0.5 * world.stableTimeStep();
    world.updateForces();
    double largestOverlap = 0;
    for (int i = 0; i < static_cast<int>(9 / timeStep); ++i)
    {
        world.step(timeStep);
        largestOverlap = std::max(largestOverlap, world.largestRelativeOverlap());
    }
    // 1.9 m to the ball, 2.95 m to the wall and back. v sqrt(m/k) deep in the wall.
    EXPECT_NEAR(world.bodies().velocity[0].x(), -1, 0.01);
    EXPECT_NEAR(world.bodies().velocity[1].x(), 0, 0.01);
    const double mass = 2650 * world.areaOf(0);
    EXPECT_NEAR(largestOverlap, std::sqrt(mass / 1e6) / world.sizeOf(0), 0.02 * largestOverlap);
}

TEST(WorldContacts, aWallTouchesInTheMiddleOfTheOverlap)
{
    WorldSettings settings = test::freeBall();
    settings.shapes = {{"egg", Ellipse(0.05, 0.03)}};
    settings.walls = {test::floorWall()};
    settings.grains[0].position = Vector2(0.2, 0.028);
    World world(settings);
    world.updateForces();
    ASSERT_EQ(world.contacts().size(), 1u);
    const Contact<2>& contact = world.contacts()[0];
    EXPECT_TRUE(contact.withWall());
    EXPECT_NEAR(contact.depth, 0.002, 8 * epsilon);
    EXPECT_LT((contact.point - Vector2(0.2, -0.001)).norm(), 8 * epsilon);
    EXPECT_EQ(contact.normal, Vector2(0, -1));
    EXPECT_NEAR(contact.force.y(), 0.002 * 1e6, 1e-8);
}

TEST(WorldContacts, frictionHistoryOutlivesANewNeighbourList)
{
    // An egg on the floor, pushed by less than friction holds, while another grain flies past to force
    // searches.
    WorldSettings settings = test::quartzSettings();
    settings.shapes = {{"egg", Ellipse(0.05, 0.03)}};
    settings.walls = {test::floorWall()};
    GrainState resting;
    const double weight = 2650 * M_PI * 0.0015 * 9.81;
    resting.position = Vector2(0, 0.03 - weight / 1e6);
    GrainState flying;
    flying.position = Vector2(-5, 3);
    flying.velocity = Vector2(10, 0);
    flying.driven = true;
    settings.grains = {resting, flying};
    World world(settings);
    world.setExternalLoads({Vector2(0.1 * weight, 0), Vector2::Zero()}, {0, 0});
    const double timeStep = 0.5 * world.stableTimeStep();
    world.updateForces();
    for (int i = 0; i < 100000; ++i)
    {
        world.step(timeStep);
    }
    // The friction is the spring's, and holds: a forgotten spring would let it creep.
    ASSERT_FALSE(world.contacts().empty());
    EXPECT_NEAR(world.contacts()[0].force.x() / weight, -0.1, 1e-6);
    EXPECT_NEAR(world.springs()[0] * 1e6 / weight, 0.1, 1e-6);
    EXPECT_LT(world.bodies().velocity[0].norm(), 1e-9);
}
