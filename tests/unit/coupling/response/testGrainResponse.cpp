#include "coupling/response/grainResponse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace chesil
{

namespace
{

constexpr double gravity = 9.81;

WorldSettings loneDisk(double density)
{
    WorldSettings settings;
    settings.shapes.push_back({"disk", Circle(0.01)});
    settings.grains.push_back({});
    settings.materials[0].density = density;
    settings.gravity = Vector2(0, -gravity);
    settings.linear().normalStiffness = 1e5;
    return settings;
}

/// A grain in a fluid that answers its acceleration with an added mass, told one step later, as a flow solver would.
struct AddedMassFluid
{
    AddedMassFluid(double density, double addedMass)
    : world(loneDisk(density)), response(world, 1, 0.5), displaced(world.areaOf(0)), answer(1 + addedMass)
    {
    }

    double step(double interval)
    {
        const double before = world.bodies().velocity[0].y();
        response.advance(loads, interval);
        const double acceleration = (world.bodies().velocity[0].y() - before) / interval;
        // The forcing accelerates the fluid inside and the added mass.
        loads.force[0] = Vector2(0, -answer * displaced * acceleration);
        return acceleration;
    }

    World world;
    GrainResponse response;
    GrainLoads loads{1};
    double displaced;
    double answer;
};

} // namespace

TEST(GrainResponse, firstAccelerationFromRestIsThatOfADiskWithItsAddedMass)
{
    for (const double ratio : {1e-3, 0.5, 1.0, 1.25, 2.65, 1e3})
    {
        AddedMassFluid fluid(ratio, 1);
        // (s - 1) g/(s + 1), exact for a lone disk; the integrator leaves rounding.
        EXPECT_NEAR(fluid.step(1e-3), -(ratio - 1) / (ratio + 1) * gravity, 1e-12 * gravity) << ratio;
    }
}

TEST(GrainResponse, settlesToTheRightAccelerationWhateverTheAddedMass)
{
    struct Case
    {
        double density;
        double addedMass;
    };
    // Up to the limit m_a < 5 m + 6 m_f of the class; the last three diverge without relaxation.
    for (const Case c : {Case{2.65, 1}, Case{1.25, 0.5}, Case{2.65, 2.3}, Case{2.65, 12}, Case{1.25, 7}, Case{1e-3, 5}})
    {
        AddedMassFluid fluid(c.density, c.addedMass);
        double acceleration = 0;
        for (int step = 0; step < 400; ++step)
        {
            acceleration = fluid.step(1e-3);
        }
        const double expected = -(c.density - 1) / (c.density + c.addedMass) * gravity;
        EXPECT_NEAR(acceleration, expected, 1e-9 * gravity) << c.density << " " << c.addedMass;
    }
}

TEST(GrainResponse, theLimitOfStabilityIsWhereTheDerivationPutsIt)
{
    AddedMassFluid beyond(1.25, 5 * 1.25 + 6 + 0.5);
    double acceleration = 0;
    for (int step = 0; step < 2000; ++step)
    {
        acceleration = beyond.step(1e-3);
    }
    EXPECT_GT(std::abs(acceleration), 1e3 * gravity);
}

TEST(GrainResponse, aDrivenGrainKeepsItsVelocityUnderAnyLoad)
{
    WorldSettings settings = loneDisk(2);
    settings.grains[0].velocity = Vector2(0.3, -0.1);
    settings.grains[0].driven = true;
    World world(settings);
    GrainResponse response(world, 1, 0.5);
    GrainLoads loads(1);
    loads.force[0] = Vector2(1e3, 1e3);
    EXPECT_EQ(response.advance(loads, 0.1), StepStatus::done);
    EXPECT_EQ(world.bodies().velocity[0], Vector2(0.3, -0.1));
    EXPECT_LT((world.bodies().pose[0].position - Vector2(0.03, -0.01)).norm(), 1e-15);
}

TEST(GrainResponse, anIntervalThatIsNoTimeStepIsRefusedAndMovesNothing)
{
    for (const double interval : {0.0, -1e-3, std::nan(""), std::numeric_limits<double>::infinity()})
    {
        AddedMassFluid fluid(2, 1);
        EXPECT_EQ(fluid.response.advance(fluid.loads, interval), StepStatus::badTimeStep) << interval;
        EXPECT_EQ(fluid.world.bodies().pose[0].position, Vector2(0, 0)) << interval;
        EXPECT_EQ(fluid.world.bodies().velocity[0], Vector2(0, 0)) << interval;
    }
}

} // namespace chesil
