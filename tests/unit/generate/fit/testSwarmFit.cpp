#include "generate/fit/swarmFit.hpp"

#include "core/base/setupError.hpp"
#include "core/base/tolerances.hpp"
#include "core/shapes/polyBezier.hpp"
#include "generate/image/convexHull.hpp"
#include "generate/fit/grainFit.hpp"
#include "unit/generate/chartShapes.hpp"

#include <gtest/gtest.h>

using namespace chesil;

TEST(ParticleSwarm, findsTheLowestOfManyHollows)
{
    // Rastrigin's function: about 100 hollows in this box
    const auto cost = [](const Eigen::ArrayXd& x)
    { return (x.square() - 10 * (2 * M_PI * x).cos() + 10).sum(); };
    const Eigen::ArrayXd bound = Eigen::ArrayXd::Constant(2, 5.12);
    SwarmSettings settings;
    settings.iterations = 200;
    EXPECT_LT(minimiseBySwarm(cost, -bound, bound, settings).matrix().norm(), 1e-3);
}

TEST(ParticleSwarm, staysInItsBoxAndRepeatsToTheBit)
{
    const auto cost = [](const Eigen::ArrayXd& x) { return x.sum(); };
    const Eigen::ArrayXd lower = Eigen::ArrayXd::Constant(3, 1.5);
    const Eigen::ArrayXd found = minimiseBySwarm(cost, lower, lower + 2);
    EXPECT_TRUE((found == lower).all());
    const auto hollow = [](const Eigen::ArrayXd& x) { return (x - 2.1).square().sum(); };
    EXPECT_TRUE(
        (minimiseBySwarm(hollow, lower, lower + 2) == minimiseBySwarm(hollow, lower, lower + 2)).all());
    SwarmSettings other;
    other.seed = 2;
    EXPECT_FALSE(
        (minimiseBySwarm(hollow, lower, lower + 2) == minimiseBySwarm(hollow, lower, lower + 2, other))
            .all());
}

TEST(SwarmFit, ofADiskIsTheDisk)
{
    const Silhouette disk =
        test::drawn(210, 210, [](const Vector2& p) { return (p - Vector2(105, 105)).norm() <= 100; });
    const PolyBezier grain(fitBySwarm(disk, convexOutline(disk), 8));
    EXPECT_EQ(grain.segments().size(), 8u);
    EXPECT_LE(grain.largestJointAngle(), tolerances::joint);
    for (int i = 0; i < 100; ++i)
    {
        const Vector2 direction(std::cos(0.0628 * i), std::sin(0.0628 * i));
        EXPECT_NEAR(direction.dot(grain.support(direction)), 100, 0.8);
    }
}

/// A joint that stands at a hull's vertex for several directions is a corner. Two sides have no direction of
/// their own: their segments may bulge by half a pixel, which no pixel sees.
TEST(SwarmFit, ofASquareIsTheSquare)
{
    const Silhouette square(60, 60, std::vector<std::uint8_t>(3600, 1));
    const PolyBezier grain(fitBySwarm(square, convexOutline(square), 10));
    EXPECT_NEAR(grain.massProperties().area, 3600, 2 * 60 * 0.5);
}

TEST(SwarmFit, isConvexForAllShapesOfTheChart)
{
    for (const double sphericity : test::chartSphericities())
    {
        for (const double roundness : test::chartRoundnesses())
        {
            const Silhouette shape = test::drawnChartShape(sphericity, roundness, 100);
            for (const int segments : {3, 10, 16})
            {
                FitSettings settings;
                settings.segments = segments;
                settings.method = FitMethod::swarm;
                settings.swarm.iterations = 20;
                const GrainFit fit = fitGrain(shape, settings);
                EXPECT_GE(fit.accuracySilhouette, segments < 10 ? 0.9 : 0.96);
            }
        }
    }
}

TEST(SwarmFit, refusesTooFewSegments)
{
    const Silhouette square(6, 6, std::vector<std::uint8_t>(36, 1));
    EXPECT_THROW(fitBySwarm(square, convexOutline(square), 2), ValueError);
}
