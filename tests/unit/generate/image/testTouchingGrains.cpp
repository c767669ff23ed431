#include "generate/image/touchingGrains.hpp"

#include "unit/generate/drawnShapes.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

/// Two disks side by side, the second of `ratio` times the first's radius, in one picture; the half width of
/// the neck is `neck` times the smaller radius.
Silhouette twoDisks(double radius, double ratio, double neck, double angle)
{
    const double small = radius * ratio;
    const double halfNeck = neck * small;
    const double apart =
        std::sqrt(radius * radius - halfNeck * halfNeck) + std::sqrt(small * small - halfNeck * halfNeck);
    const Vector2 first(3 * radius, 3 * radius);
    const Vector2 second = first + apart * Vector2(std::cos(angle), std::sin(angle));
    return test::drawn(static_cast<int>(6 * radius), static_cast<int>(6 * radius),
                       [&](const Vector2& p)
                       { return (p - first).norm() <= radius || (p - second).norm() <= small; });
}

Silhouette spiral(int size)
{
    return test::drawn(size, size,
                       [&](const Vector2& p)
                       {
                           const Vector2 local = p - Vector2(size / 2.0, size / 2.0);
                           const double turns = local.norm() / (size / 8.0);
                           const double angle = std::atan2(local.y(), local.x()) / (2 * M_PI);
                           const double phase = turns - angle - std::floor(turns - angle);
                           return turns - phase < 3 && phase < 0.5;
                       });
}

} // namespace

TEST(Convexity, isOneOfConvexShapesAndSmallOfASpiral)
{
    test::RandomSource random(3);
    for (int trial = 0; trial < 100; ++trial)
    {
        const test::DrawnEllipse ellipse = test::randomEllipse(8, 60, random);
        EXPECT_GT(convexity(test::drawn(ellipse.boxSize(), ellipse.boxSize(), ellipse)), 0.97);
    }
    EXPECT_LT(convexity(spiral(200)), 0.65);
    // Two of the four quarters of a square: two thirds of the hull.
    EXPECT_NEAR(
        convexity(test::drawn(400, 400, [](const Vector2& p) { return (p.x() < 200) == (p.y() < 200); })),
        2.0 / 3, 2e-3);
}

TEST(PartsAtNecks, ofTouchingDisksAreTheDisks)
{
    test::RandomSource random(4);
    for (int trial = 0; trial < 100; ++trial)
    {
        const double radius = random.uniform(20, 60);
        const double ratio = random.uniform(0.5, 1);
        const double neck = random.uniform(0.1, 0.45);
        const Silhouette both = twoDisks(radius, ratio, neck, random.uniform(0, 2 * M_PI));
        const std::vector<Silhouette> parts = partsAtNecks(both);
        ASSERT_EQ(parts.size(), 2u) << radius << ' ' << ratio << ' ' << neck;
        EXPECT_EQ(parts[0].count() + parts[1].count(), both.count());
        const double larger = std::max(parts[0].count(), parts[1].count());
        EXPECT_NEAR(larger, M_PI * radius * radius, 0.06 * larger) << radius << ' ' << ratio << ' ' << neck;
        for (const Silhouette& part : parts)
        {
            EXPECT_GT(convexity(part), 0.95) << radius << ' ' << ratio << ' ' << neck;
        }
    }
}

TEST(PartsAtNecks, ofAWaistAreOne)
{
    test::RandomSource random(5);
    for (int trial = 0; trial < 50; ++trial)
    {
        const Silhouette both =
            twoDisks(random.uniform(20, 60), 1, random.uniform(0.72, 0.95), random.uniform(0, M_PI));
        EXPECT_EQ(partsAtNecks(both).size(), 1u) << trial;
    }
}

TEST(PartsAtNecks, ofSingleGrainsAreOne)
{
    test::RandomSource random(6);
    for (int trial = 0; trial < 50; ++trial)
    {
        const test::DrawnEllipse ellipse = test::randomEllipse(8, 80, random);
        EXPECT_EQ(partsAtNecks(test::drawn(ellipse.boxSize(), ellipse.boxSize(), ellipse)).size(), 1u);
    }
    EXPECT_EQ(partsAtNecks(spiral(200)).size(), 1u);
    const Silhouette crescent =
        test::drawn(120, 120,
                    [](const Vector2& p)
                    { return (p - Vector2(60, 60)).norm() < 50 && (p - Vector2(90, 60)).norm() > 40; });
    EXPECT_EQ(partsAtNecks(crescent).size(), 1u);
    EXPECT_EQ(partsAtNecks(Silhouette(1, 1, {1})).size(), 1u);
}

TEST(PartsAtNecks, smallOnesBelongToTheirNeighbours)
{
    const Silhouette both = twoDisks(40, 0.6, 0.3, 0.4);
    TouchCriterion criterion;
    EXPECT_EQ(partsAtNecks(both, criterion).size(), 2u);
    criterion.minPixels = 2500;
    EXPECT_EQ(partsAtNecks(both, criterion).size(), 1u);
}

TEST(PartsAtNecks, ofAChainAreAllOfIt)
{
    const Silhouette chain = test::drawn(400, 400,
                                         [](const Vector2& p)
                                         {
                                             for (int i = 0; i < 5; ++i)
                                             {
                                                 if ((p - Vector2(60 + 56 * i, 80 + 40 * i)).norm() < 36)
                                                 {
                                                     return true;
                                                 }
                                             }
                                             return false;
                                         });
    const std::vector<Silhouette> parts = partsAtNecks(chain);
    ASSERT_EQ(parts.size(), 5u);
    // From the top, that is the highest first.
    EXPECT_GT(parts[0].corner().y(), parts[4].corner().y());
}
