#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// One ball in free space, of mass and inertia as given by its shape.
WorldSettings freeBall()
{
    WorldSettings settings = test::quartzSettings();
    settings.gravity = Vector2::Zero();
    settings.localDamping = 0;
    settings.shapes = {{"ball", Circle(0.05)}};
    settings.grains = {GrainState{}};
    return settings;
}

} // namespace

TEST(World, withoutGrainsAndWithOne)
{
    World empty(test::quartzSettings());
    EXPECT_EQ(empty.stableTimeStep(), std::numeric_limits<double>::infinity());
    empty.updateForces();
    EXPECT_EQ(empty.step(1e-3), StepStatus::done);
    EXPECT_EQ(empty.largestRelativeOverlap(), 0);

    WorldSettings settings = freeBall();
    settings.gravity = Vector2(0, -10);
    settings.grains[0].velocity = Vector2(3, 0);
    World one(settings);
    one.updateForces();
    for (int i = 0; i < 1000; ++i)
    {
        ASSERT_EQ(one.step(1e-3), StepStatus::done);
    }
    // Velocity Verlet is exact for a constant force.
    EXPECT_NEAR(one.bodies().pose[0].position.x(), 3, 1e-12);
    EXPECT_NEAR(one.bodies().pose[0].position.y(), -5, 1e-12);
    EXPECT_NEAR(one.bodies().velocity[0].y(), -10, 1e-12);
}

TEST(World, aGrainThatIsNoNumberIsReported)
{
    for (const int broken : {0, 5, 11})
    {
        WorldSettings settings = test::mixedScene(12, 151);
        settings.grains[static_cast<std::size_t>(broken)].velocity.y() =
            std::numeric_limits<double>::quiet_NaN();
        World world(settings);
        world.updateForces();
        EXPECT_EQ(world.step(1e-5), StepStatus::notFinite);
        EXPECT_EQ(world.brokenGrain(), static_cast<std::size_t>(broken));
    }
    WorldSettings settings = test::mixedScene(12, 151);
    settings.grains[3].angularVelocity = std::numeric_limits<double>::infinity();
    World world(settings);
    world.updateForces();
    EXPECT_EQ(world.step(1e-5), StepStatus::notFinite);
    EXPECT_EQ(world.brokenGrain(), 3u);
}

TEST(World, externalLoadsMoveAndTurnAndAreHeld)
{
    World world(freeBall());
    const double mass = 2650 * world.areaOf(0);
    const double inertia = 2650 * world.polarMomentOf(0);
    world.setExternalLoads({Vector2(2, -1)}, {0.5});
    world.updateForces();
    for (int i = 0; i < 100; ++i)
    {
        world.step(1e-2);
    }
    EXPECT_LT((world.bodies().velocity[0] - Vector2(2, -1) / mass).norm(), 1e-14);
    EXPECT_NEAR(world.bodies().angularVelocity[0] * inertia / 0.5, 1, 1e-12);
    EXPECT_NEAR(world.bodies().pose[0].rotation.angle() * inertia / 0.25, 1, 1e-12);
}

TEST(World, immerseGivesTheBuoyantWeightAndTheVirtualMass)
{
    WorldSettings settings = freeBall();
    settings.gravity = Vector2(1, -9.81);
    for (const double virtualMass : {0.0, 1.0})
    {
        World world(settings);
        world.immerse(1000, virtualMass);
        world.updateForces();
        const Vector2 weight = (2650 - 1000) * world.areaOf(0) * settings.gravity;
        EXPECT_LT((world.bodies().force[0] - weight).norm(), 8 * epsilon * weight.norm());
        world.step(0.1);
        const Vector2 expected = 0.1 * (2650 - 1000) / (2650 + virtualMass * 1000) * settings.gravity;
        EXPECT_LT((world.bodies().velocity[0] - expected).norm(), 1e-14);
        EXPECT_NEAR(world.bodies().inverseInertia[0] * (2650 + virtualMass * 1000) * world.polarMomentOf(0),
                    1, 8 * epsilon);
    }
    // Of the fluid's density it floats.
    World floating(settings);
    floating.immerse(2650, 0);
    floating.updateForces();
    EXPECT_EQ(floating.bodies().force[0], Vector2::Zero());
}

TEST(World, drivenGrainsKeepTheirVelocityButPush)
{
    WorldSettings settings = freeBall();
    settings.contact.friction = 0;
    settings.grains.push_back(settings.grains[0]);
    settings.grains[0].driven = true;
    settings.grains[0].velocity = Vector2(1, 0);
    settings.grains[1].position = Vector2(0.11, 0);
    World world(settings);
    world.immerse(1000, 0);
    const double timeStep = 0.1 * world.stableTimeStep();
    world.updateForces();
    while (world.bodies().pose[0].position.x() < 0.1)
    {
        world.step(timeStep);
    }
    EXPECT_EQ(world.bodies().velocity[0], Vector2(1, 0));
    // Struck by an infinite mass without loss: twice its velocity.
    EXPECT_NEAR(world.bodies().velocity[1].x(), 2, 1e-3);
}

TEST(World, momentumIsKeptWithoutWallsAndLoads)
{
    WorldSettings settings = test::mixedScene(40, 152);
    settings.walls.clear();
    settings.gravity = Vector2::Zero();
    settings.localDamping = 0;
    settings.contact.dampingRatio = 0.2;
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

TEST(World, farFromTheOriginTheContactsAreAlike)
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

TEST(World, theStableStepKnowsDampingStiffnessAndVirtualMass)
{
    WorldSettings settings = freeBall();
    settings.contact.tangentialStiffness = 0;
    const double step = World(settings).stableTimeStep();
    // A disk: 1 + m R^2/I = 3, six contacts.
    const double mass = 2650 * M_PI * 0.05 * 0.05;
    EXPECT_NEAR(step * std::sqrt(36 * 1e6 / mass), 2, 1e-12);
    settings.localDamping = 0.7;
    EXPECT_NEAR(World(settings).stableTimeStep() * std::sqrt(1.7), step, 1e-12 * step);
    settings.localDamping = 0;
    settings.contact.tangentialStiffness = 4e6;
    EXPECT_NEAR(World(settings).stableTimeStep(), step / 2, 1e-12 * step);
    settings.contact.tangentialStiffness = 0;
    settings.contact.dampingRatio = 0.1;
    EXPECT_LT(World(settings).stableTimeStep(), 0.9 * step);
    settings.contact.dampingRatio = 0;
    World wet(settings);
    wet.immerse(1000, 1);
    EXPECT_NEAR(wet.stableTimeStep(), step * std::sqrt(3650 / 2650.0), 1e-12 * step);
}

TEST(World, whatComesFromAfarIsNotMissed)
{
    // Over many skins of the neighbour list to a resting ball, which flies on to a wall.
    WorldSettings settings = freeBall();
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

TEST(World, aWallTouchesInTheMiddleOfTheOverlap)
{
    WorldSettings settings = freeBall();
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

TEST(World, frictionHistoryOutlivesANewNeighbourList)
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
    flying.velocity = Vector2(50, 0);
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
    EXPECT_NEAR(world.contacts()[0].spring.x() * 1e6 / weight, 0.1, 1e-6);
    EXPECT_LT(world.bodies().velocity[0].norm(), 1e-9);
}
