#include "core/measure/alignment.hpp"

#include "core/base/setupError.hpp"
#include "unit/core/measure/directedContacts.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;
using namespace chesil::test;

using Rose = std::vector<std::size_t>;

TEST(Alignment, parallelAxesWhicheverWayAndTurn)
{
    const SecondHarmonic found = alignment({0.3, 0.3 + M_PI, 0.3 - M_PI, 0.3 + 8 * M_PI}).value();
    EXPECT_NEAR(found.amplitude(), 1, 1e-14);
    EXPECT_LE(axisDistance(found.direction().value(), 0.3), 1e-14);
}

TEST(Alignment, crossedAxesHaveNoOrder)
{
    EXPECT_LE(alignment({0.3, 0.3 + M_PI / 2}).value().amplitude(), 1e-15);
    EXPECT_LE(alignment({0, M_PI / 3, 2 * M_PI / 3}).value().amplitude(), 1e-15);
}

TEST(Alignment, twoAxes)
{
    const SecondHarmonic found = alignment({1.0, 1.4}).value();
    EXPECT_DOUBLE_EQ(found.amplitude(), std::cos(0.4));
    EXPECT_DOUBLE_EQ(found.direction().value(), 1.2);
}

/// E(t) with the amplitude a has S = a/2.
TEST(Alignment, knownDensity)
{
    const DirectedForces given{0.6, 2.5, 1, 0, 0, 0, 0};
    std::vector<double> angles;
    for (int i = 0; i < 200; ++i)
    {
        angles.push_back(given.direction((i + 0.5) / 200));
    }
    EXPECT_NEAR(alignment(angles).value().amplitude(), 0.3, 1e-14);
    EXPECT_LE(axisDistance(alignment(angles).value().direction().value(), 2.5), 1e-14);
}

TEST(Alignment, turnsWithTheAxes)
{
    RandomSource random(80);
    std::vector<double> angles;
    for (int i = 0; i < 50; ++i)
    {
        angles.push_back(random.uniform(-4, 9));
    }
    const SecondHarmonic before = alignment(angles).value();
    for (double& angle : angles)
    {
        angle += 2.1;
    }
    const SecondHarmonic after = alignment(angles).value();
    EXPECT_NEAR(after.amplitude(), before.amplitude(), 1e-14);
    EXPECT_LE(axisDistance(after.direction().value(), before.direction().value() + 2.1), 1e-13);
}

TEST(Alignment, nothingWithoutAxes) { EXPECT_FALSE(alignment({})); }

TEST(AxialData, axisAngleIsInHalfTurn)
{
    EXPECT_EQ(axisAngle(0), 0);
    EXPECT_EQ(axisAngle(M_PI), 0);
    EXPECT_EQ(axisAngle(-M_PI), 0);
    EXPECT_EQ(axisAngle(-1e-30), 0);
    EXPECT_EQ(axisAngle(M_PI / 2), M_PI / 2);
    EXPECT_EQ(axisAngle(-M_PI / 2), M_PI / 2);
    RandomSource random(81);
    for (int i = 0; i < 1000; ++i)
    {
        const double angle = random.uniform(-100, 100);
        EXPECT_GE(axisAngle(angle), 0);
        EXPECT_LT(axisAngle(angle), M_PI);
        EXPECT_LE(axisDistance(axisAngle(angle), angle), 1e-13);
    }
}

TEST(AxialData, roseIsCentredOnMultiples)
{
    const double width = M_PI / 4;
    EXPECT_EQ(roseHistogram({-1e-17, 1e-17, 0, M_PI, -7 * M_PI, 0.49 * width, -0.49 * width}, 4),
              (Rose{7, 0, 0, 0}));
    EXPECT_EQ(roseHistogram({0.51 * width, M_PI / 2, -M_PI / 2, -0.51 * width}, 4), (Rose{0, 1, 2, 1}));
    EXPECT_EQ(roseHistogram({0.1, 1, 2, 3}, 1), (Rose{4}));
    EXPECT_EQ(roseHistogram({}, 3), (Rose{0, 0, 0}));
}

/// Angles next to the bins' edges fall into one of both, never outside.
TEST(AxialData, roseHoldsAnglesAtEdges)
{
    for (std::size_t bins = 1; bins < 200; ++bins)
    {
        EXPECT_LT(std::nextafter(M_PI, 0) / M_PI * static_cast<double>(bins), static_cast<double>(bins));
        for (std::size_t k = 0; k < bins; ++k)
        {
            const double edge = (static_cast<double>(k) + 0.5) * M_PI / static_cast<double>(bins);
            for (const double angle : {std::nextafter(edge, 0), edge, std::nextafter(edge, 9), edge - M_PI})
            {
                const std::size_t found = roseBin(angle, bins);
                EXPECT_TRUE(found == k || found == (k + 1) % bins);
            }
        }
    }
}

TEST(AxialData, refusesWhatHasNoBin)
{
    EXPECT_THROW(roseHistogram({1}, 0), ValueError);
    EXPECT_THROW(roseHistogram({std::numeric_limits<double>::quiet_NaN()}, 3), ValueError);
    EXPECT_THROW(roseHistogram({std::numeric_limits<double>::infinity()}, 3), ValueError);
}

TEST(AxialData, harmonicWithoutAmplitudeHasNoDirection)
{
    EXPECT_FALSE(SecondHarmonic{}.direction());
    EXPECT_DOUBLE_EQ((SecondHarmonic{0, -2}.direction().value()), 3 * M_PI / 4);
    EXPECT_EQ((SecondHarmonic{3, 4}.amplitude()), 5);
}
