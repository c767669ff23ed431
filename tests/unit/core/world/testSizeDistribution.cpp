#include "core/base/setupError.hpp"
#include "core/world/sizeDistribution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace chesil;
using testing::HasSubstr;

namespace
{

const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();

double normalShareBelow(double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; }

std::string refusal(const std::function<void()>& make)
{
    try
    {
        make();
    }
    catch (const ValueError& error)
    {
        EXPECT_NE(error.expected(), "");
        return error.found();
    }
    ADD_FAILURE() << "not refused";
    return "";
}

double sumOfShares(const SizeClasses& sizes)
{
    double sum = 0;
    for (const SizeClass& one : sizes.classes)
    {
        sum += one.share;
    }
    return sum;
}

} // namespace

TEST(SizeDistribution, normalQuantileIsTheInverseOfItsShare)
{
    // Known: Wichura's own test values, and the 97.5 % point.
    EXPECT_DOUBLE_EQ(normalQuantile(0.25), -0.6744897501960817);
    EXPECT_DOUBLE_EQ(normalQuantile(0.001), -3.090232306167814);
    EXPECT_DOUBLE_EQ(normalQuantile(1e-20), -9.262340089798408);
    EXPECT_DOUBLE_EQ(normalQuantile(0.975), 1.959963984540054);
    EXPECT_EQ(normalQuantile(0.5), 0);
    for (double z = -30; z <= 5; z += 0.01)
    {
        EXPECT_NEAR(normalQuantile(normalShareBelow(z)), z, 2e-11 * (1 + std::abs(z))) << z;
    }
}

TEST(SizeDistribution, uniformRatiosHaveTheirMean)
{
    const UniformRatio ratios(0.5, 2);
    EXPECT_EQ(ratios.quantile(0), 0.5);
    EXPECT_EQ(ratios.quantile(1), 2);
    const SizeClasses sizes = sizeClasses(ratios, 32);
    EXPECT_TRUE(sizes.areRatios);
    double mean = 0;
    for (const SizeClass& one : sizes.classes)
    {
        mean += one.share * one.size;
    }
    EXPECT_NEAR(mean, 1.25, 1e-14);
    EXPECT_EQ(UniformRatio(1, 1).quantile(0.3), 1);
}

TEST(SizeDistribution, lognormalIsTheClosedForm)
{
    // Wide ends: the median is the median, one deviation of the logarithm away lie 84 %.
    const LognormalSize wide(0.01, 0.5, 1e-8, 1e4);
    EXPECT_NEAR(wide.quantile(0.5), 0.01, 1e-15);
    EXPECT_NEAR(wide.quantile(normalShareBelow(1)) / (0.01 * std::exp(0.5)), 1, 1e-14);
    EXPECT_NEAR(wide.quantile(normalShareBelow(-2)) / (0.01 * std::exp(-1.0)), 1, 1e-14);

    // Cut off evenly in the logarithm: still the median; at p the share between the ends is p.
    const LognormalSize even(0.01, 0.5, 0.005, 0.02);
    EXPECT_NEAR(even.quantile(0.5), 0.01, 1e-15);
    const LognormalSize cut(0.01, 0.3, 0.009, 0.03);
    const auto share = [](double size) { return normalShareBelow(std::log(size / 0.01) / 0.3); };
    for (double p = 0.01; p < 1; p += 0.01)
    {
        const double between = (share(cut.quantile(p)) - share(0.009)) / (share(0.03) - share(0.009));
        EXPECT_NEAR(between, p, 1e-13);
    }
}

TEST(SizeDistribution, lognormalEndsAreItsEnds)
{
    // On one side of the median, on the other, across it; in the far tails too.
    const double ends[][2]{{0.005, 0.02}, {0.001, 0.006}, {0.02, 0.1}, {0.0243, 0.5}, {1e-5, 0.0041}};
    for (const auto& [least, largest] : ends)
    {
        const LognormalSize sizes(0.01, 0.2, least, largest);
        EXPECT_NEAR(sizes.quantile(0) / least, 1, 1e-15);
        EXPECT_NEAR(sizes.quantile(1) / largest, 1, least > 0.01 || largest < 0.01 ? 1e-9 : 1e-14);
        double last = 0;
        for (double p = 0; p <= 1; p += 1.0 / 128)
        {
            const double size = sizes.quantile(p);
            EXPECT_GE(size, least);
            EXPECT_LE(size, largest);
            EXPECT_GT(size, last);
            last = size;
        }
    }
    // Mirrored ranges in the logarithm mirror the sizes.
    const LognormalSize above(1, 0.15, 2, 4);
    const LognormalSize below(1, 0.15, 0.25, 0.5);
    for (double p = 0.125; p < 1; p += 0.125)
    {
        EXPECT_NEAR(above.quantile(p) * below.quantile(1 - p), 1, 1e-14);
    }
}

TEST(SizeDistribution, sieveCurveGoesThroughItsPoints)
{
    const SieveCurve curve({0.001, 0.002, 0.008, 0.01, 0.05}, {0, 0.2, 0.7, 0.7, 1});
    EXPECT_EQ(curve.quantile(0), 0.001);
    EXPECT_DOUBLE_EQ(curve.quantile(0.2), 0.002);
    EXPECT_DOUBLE_EQ(curve.quantile(1), 0.05);
    // Half way between two points: the geometric mean of the sizes.
    EXPECT_DOUBLE_EQ(curve.quantile(0.45), 0.004);
    EXPECT_DOUBLE_EQ(curve.quantile(0.85), std::sqrt(0.01 * 0.05));
    // Nothing has a size where the curve is flat.
    for (double p = 0; p <= 1; p += 1.0 / 1024)
    {
        const double size = curve.quantile(p);
        EXPECT_FALSE(size > 0.008 * (1 + 1e-12) && size < 0.01 * (1 - 1e-12));
    }
}

TEST(SizeDistribution, classesOfASieveCurveHaveItsMass)
{
    const std::vector<double> sieves{0.001, 0.002, 0.008, 0.05};
    const std::vector<double> passing{0, 0.11, 0.7, 1};
    const SizeClasses sizes = sizeClasses(SieveCurve(sieves, passing), 32);
    EXPECT_NEAR(sumOfShares(sizes), 1, 1e-14);
    EXPECT_LE(sizes.classes.size(), 34u);
    double whole = 0;
    for (const SizeClass& one : sizes.classes)
    {
        whole += one.share * one.size * one.size;
    }
    for (std::size_t i = 0; i < sieves.size(); ++i)
    {
        double finer = 0;
        for (const SizeClass& one : sizes.classes)
        {
            finer += one.size < sieves[i] ? one.share * one.size * one.size : 0;
        }
        EXPECT_NEAR(finer / whole, passing[i], 1e-13);
    }
}

TEST(SizeDistribution, classesAreTheMiddlesOfEqualShares)
{
    const LognormalSize distribution(0.01, 0.4, 0.002, 0.05);
    const SizeClasses sizes = sizeClasses(distribution, 10);
    ASSERT_EQ(sizes.classes.size(), 10u);
    EXPECT_FALSE(sizes.areRatios);
    EXPECT_NEAR(sumOfShares(sizes), 1, 1e-15);
    EXPECT_EQ(sizes.classes[3].size, distribution.quantile(0.35));
    EXPECT_EQ(sizeClasses(distribution, 1).classes[0].size, distribution.quantile(0.5));
    EXPECT_THAT(refusal([&] { sizeClasses(distribution, 0); }), HasSubstr("0 classes"));
}

TEST(SizeDistribution, impossibleOnesAreRefused)
{
    for (const double bad : {0.0, -1.0, infinite, notANumber})
    {
        refusal([&] { UniformRatio(bad, 2); });
        refusal([&] { UniformRatio(1, bad); });
        refusal([&] { LognormalSize(bad, 0.5, 0.1, 1); });
        refusal([&] { LognormalSize(0.5, bad, 0.1, 1); });
        refusal([&] { LognormalSize(0.5, 0.5, bad, 1); });
        refusal([&] { LognormalSize(0.5, 0.5, 0.1, bad); });
        refusal([&] { SieveCurve({bad, 2}, {0, 1}); });
        refusal([&] { SieveCurve({1, 2, bad}, {0, 0.5, 1}); });
    }
    EXPECT_THAT(refusal([] { UniformRatio(2, 1); }), HasSubstr("sizes from 2 to 1"));
    EXPECT_THAT(refusal([] { LognormalSize(5, 0.3, 0.005, 0.02); }),
                HasSubstr("of the grains about the median 5"));
    EXPECT_THAT(refusal([] { LognormalSize(0.01, 0.3, 0.01, 0.01); }), HasSubstr("which hold 0 of"));
    EXPECT_THAT(refusal([] { SieveCurve({1}, {1}); }), HasSubstr("1 sizes and 1 values"));
    EXPECT_THAT(refusal([] { SieveCurve({1, 2, 3}, {0, 1}); }), HasSubstr("3 sizes and 2 values"));
    EXPECT_THAT(refusal([] { SieveCurve({1, 1}, {0, 1}); }), HasSubstr("sieve size 1 after 1"));
    EXPECT_THAT(refusal([] { SieveCurve({1, 2, 3}, {0, 0.5, 0.4}); }), HasSubstr("passing 0.4 after 0.5"));
    EXPECT_THAT(refusal([] { SieveCurve({1, 2}, {0.1, 1}); }), HasSubstr("passing from 0.1 to 1"));
    EXPECT_THAT(refusal([] { SieveCurve({1, 2}, {0, 100}); }), HasSubstr("passing from 0 to 100"));
    EXPECT_THAT(refusal([] { SieveCurve({1, 2, 3}, {0, notANumber, 1}); }), HasSubstr("after 0"));
}
