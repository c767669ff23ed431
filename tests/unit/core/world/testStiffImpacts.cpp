#include "core/contact/restitution.hpp"
#include "core/world/world.hpp"

#include "unit/core/world/worldScenes.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

// Restitution at stiffnesses over nine decades at the automatic step. Asked for is that of one contact between two
// bodies that meet along the line of their centroids; only there a coefficient of restitution says how they part.

using namespace chesil;

namespace
{

constexpr double automaticShare = 0.5;
constexpr double speed = 0.1;

/// Angle [rad] at which the grain meets a wall below with its lowest point right under its centroid.
double centralAngle(const Shape& shape)
{
    const auto arm = [&](double angle)
    {
        const Rotation<2> rotation(angle);
        return rotation.apply(support(shape, rotation.applyInverse(Vector2(0, -1)))).x();
    };
    double low = 0;
    double high = 0;
    while (arm(low) * arm(high) >= 0)
    {
        low = high;
        high += 0.05;
    }
    const bool rising = arm(high) > 0;
    for (int i = 0; i < 60; ++i)
    {
        const double middle = (low + high) / 2;
        ((arm(middle) > 0) == rising ? high : low) = middle;
    }
    return high;
}

WorldSettings impactSettings(double stiffness, double restitution)
{
    WorldSettings settings = test::freeBall();
    settings.linear().normalStiffness = stiffness;
    settings.linear().tangentialStiffness = 0.8 * stiffness;
    settings.linear().friction = 0.3;
    settings.linear().dampingRatio = dampingRatioOf(restitution);
    settings.grains.clear();
    return settings;
}

/// Of the normal velocity of grain 0 less that of grain 1, if there is one, after and before.
double measuredRestitution(World& world, double timeStep)
{
    const auto approach = [&world]
    {
        const std::vector<Vector2>& velocity = world.bodies().velocity;
        return velocity.size() > 1 ? velocity[1].y() - velocity[0].y() : -velocity[0].y();
    };
    const double before = approach();
    const auto touches = [&world]
    {
        return std::any_of(world.contacts().begin(), world.contacts().end(), [](const Contact<2>& c) { return c.depth > 0; });
    };
    world.updateForces();
    bool hit = false;
    for (int i = 0; i < 5000; ++i)
    {
        EXPECT_EQ(world.step(timeStep), StepStatus::done);
        if (hit && !touches())
        {
            return -approach() / before;
        }
        hit = hit || touches();
    }
    ADD_FAILURE() << "no end of the contact";
    return 0;
}

/// `angle` turns the grain; it starts `gap` automatic steps from the wall.
double wallRestitution(WorldSettings settings, const Shape& shape, double angle, double gap)
{
    settings.shapes = {{"grain", shape}};
    settings.walls = {test::floorWall()};
    settings.grains = {GrainState{}};
    GrainState& grain = settings.grains[0];
    grain.angle = angle;
    grain.velocity = Vector2(0, -speed);
    const double timeStep = automaticShare * World(settings).stableTimeStep();
    const Rotation<2> rotation(angle);
    const double height = -rotation.apply(support(shape, rotation.applyInverse(Vector2(0, -1)))).y();
    grain.position = Vector2(0, height + gap * timeStep * speed);
    World world(settings);
    return measuredRestitution(world, timeStep);
}

/// The first grain above, as it meets a wall; the second below, turned round.
double pairRestitution(WorldSettings settings, const Shape& shape, const Shape& other, double gap)
{
    settings.shapes = {{"grain", shape}, {"other", other}};
    settings.grains.resize(2);
    double heights[2];
    for (int i = 0; i < 2; ++i)
    {
        const Shape& own = settings.shapes[static_cast<std::size_t>(i)].shape;
        const double angle = centralAngle(own);
        const Rotation<2> rotation(angle);
        heights[i] = -rotation.apply(support(own, rotation.applyInverse(Vector2(0, -1)))).y();
        settings.grains[static_cast<std::size_t>(i)].shape = i;
        settings.grains[static_cast<std::size_t>(i)].angle = i == 0 ? angle : angle + M_PI;
    }
    settings.grains[0].velocity = Vector2(0, -speed);
    const double timeStep = automaticShare * World(settings).stableTimeStep();
    settings.grains[0].position = Vector2(0, heights[0] + heights[1] + gap * timeStep * speed);
    World world(settings);
    return measuredRestitution(world, timeStep);
}

std::vector<NamedShape> roundShapes()
{
    test::RandomSource random(404);
    test::RandomGrainOptions pebble;
    pebble.radius = 0.025;
    return {{"disk", Circle(0.025)}, {"ellipse", Ellipse(0.03, 0.02)}, {"polybezier", test::randomPolyBezier(pebble, random)}};
}

constexpr double stiffnesses[] = {1e4, 1e6, 1e8, 1e10, 1e13};
constexpr double restitutions[] = {0.1, 0.3, 0.5, 0.7, 0.9, 1};
constexpr double gaps[] = {2.01, 2.3, 2.6, 2.9, 2.99};

/// Worst relative error over stiffness, restitution and place of the contact's start within a step.
template <class Measure>
double worstError(const char* name, const Measure& measure)
{
    double worst = 0;
    for (const double restitution : restitutions)
    {
        double worstHere = 0;
        for (const double stiffness : stiffnesses)
        {
            const WorldSettings settings = impactSettings(stiffness, restitution);
            for (const double gap : gaps)
            {
                worstHere = std::max(worstHere, std::abs(measure(settings, restitution, gap) / restitution - 1));
            }
        }
        std::printf("%s: restitution %.1f, off by %.2e\n", name, restitution, worstHere);
        worst = std::max(worst, worstHere);
    }
    return worst;
}

} // namespace

TEST(StiffImpacts, againstAWallPartAsAsked)
{
    double worst = 0;
    for (const NamedShape& named : roundShapes())
    {
        const double angle = centralAngle(named.shape);
        worst = std::max(worst, worstError(named.name.c_str(), [&](const WorldSettings& settings, double, double gap) {
                             return wallRestitution(settings, named.shape, angle, gap);
                         }));
    }
    EXPECT_LT(worst, 0.01);
    test::record("dryEngine", "stiffWallRestitution", worst, "-");
}

TEST(StiffImpacts, ofTwoGrainsPartAsAsked)
{
    double worst = 0;
    const std::vector<NamedShape> shapes = roundShapes();
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
        for (std::size_t j = i; j < shapes.size(); ++j)
        {
            const std::string name = shapes[i].name + " on " + shapes[j].name;
            worst = std::max(worst, worstError(name.c_str(), [&](const WorldSettings& settings, double, double gap) {
                                 return pairRestitution(settings, shapes[i].shape, shapes[j].shape, gap);
                             }));
        }
    }
    EXPECT_LT(worst, 0.01);
    test::record("dryEngine", "stiffPairRestitution", worst, "-");
}

TEST(StiffImpacts, ofASquareOnItsCornerPartAsAsked)
{
    const Shape square = test::rectangle(0.05, 0.05);
    const double worst = worstError("corner", [&](const WorldSettings& settings, double, double gap) {
        return wallRestitution(settings, square, M_PI / 4, gap);
    });
    EXPECT_LT(worst, 0.01);
    test::record("dryEngine", "stiffCornerRestitution", worst, "-");
}

TEST(StiffImpacts, ofASquareThatFallsFlatPartAsAsked)
{
    const Shape square = test::rectangle(0.05, 0.05);
    const double worst = worstError("flat", [&](const WorldSettings& settings, double, double gap) {
        return wallRestitution(settings, square, 0, gap);
    });
    EXPECT_LT(worst, 0.01);
    test::record("dryEngine", "stiffFlatRestitution", worst, "-");
}
