#include "core/boundary/planeWall.hpp"

#include "core/shapes/shape.hpp"
#include "unit/knownShapes.hpp"
#include "unit/preciseCurve.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;

namespace
{

constexpr double rounding = 32 * std::numeric_limits<double>::epsilon();

} // namespace

TEST(PlaneWall, distanceIsPositiveInTheDomain)
{
    const PlaneWall<2> wall{"left", Vector2(-1, 5), Vector2(1, 0)};
    EXPECT_EQ(wall.distance({3, -7}), 4);
    EXPECT_EQ(wall.distance({-2, 0}), -1);
}

TEST(PlaneWall, footPointOfAnEllipseIsKnownByFormula)
{
    // Depth of an ellipse in a wall: sqrt(a^2 nu^2 + b^2 nv^2) less the distance of the centre.
    test::RandomSource random(131);
    for (int i = 0; i < 1000; ++i)
    {
        const double a = random.logUniform(0.1, 10);
        const double b = random.logUniform(0.1, 10);
        const Pose<2> pose = random.pose(1);
        const Vector2 normal = random.direction();
        const PlaneWall<2> wall{"wall", pose.position - random.uniform(0, 1) * normal, normal};
        const Vector2 local = pose.rotation.applyInverse(normal);
        const double depth = std::hypot(a * local.x(), b * local.y()) - wall.distance(pose.position);
        EXPECT_NEAR(-wall.distance(footPoint(Ellipse(a, b), pose, wall)), depth, rounding * std::max(a, b));
    }
}

TEST(PlaneWall, footPointIsTheDeepestOfTheOutline)
{
    test::RandomSource random(132);
    const PlaneWall<2> floor{"floor", Vector2(0, 0.25), Vector2(0, 1)};
    for (int i = 0; i < 100; ++i)
    {
        const PolyBezier grain = test::randomPolyBezier({9, 1, 1}, random);
        const Pose<2> pose = random.pose(1);
        const test::HeightSweep sweep(placed(grain.outline(), pose), 48);
        const double lowest = -static_cast<double>(sweep.height({0, -1}));
        const Vector2 foot = footPoint(grain, pose, floor);
        EXPECT_NEAR(foot.y(), lowest, rounding);
        EXPECT_NEAR(floor.distance(foot), lowest - 0.25, rounding);
    }
}

TEST(PlaneWall, aFaceFlatOnTheWallTouchesInItsMiddle)
{
    // So that a block stands without a torque. Its edges are straight polybezier segments.
    const PolyBezier block(test::polygonSegments(test::rectangleVertices(2, 1)));
    const PlaneWall<2> floor{"floor", Vector2(0, 0), Vector2(0, 1)};
    const Vector2 foot = footPoint(block, Pose<2>{Vector2(3, 0.5), {}}, floor);
    EXPECT_LT((foot - Vector2(3, 0)).norm(), rounding);
}
