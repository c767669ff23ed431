#include "core/base/setupError.hpp"
#include "core/world/composition.hpp"
#include "unit/core/world/worldScenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

using namespace chesil;
using testing::HasSubstr;

namespace
{

const Shape& shapeAt(const std::vector<NamedShape>& shapes, int index)
{
    return shapes[static_cast<std::size_t>(index)].shape;
}

double areaOf(const std::vector<NamedShape>& shapes, int index)
{
    return massProperties(shapeAt(shapes, index)).area;
}

double wholeArea(const std::vector<NamedShape>& shapes, const std::vector<int>& grains)
{
    double sum = 0;
    for (const int index : grains)
    {
        sum += areaOf(shapes, index);
    }
    return sum;
}

double diameterOf(const std::vector<NamedShape>& shapes, int index)
{
    return 2 * std::sqrt(areaOf(shapes, index) / M_PI);
}

/// Grains of each kind of shape.
std::vector<int> kinds(const std::vector<NamedShape>& shapes, const std::vector<int>& grains)
{
    std::vector<int> count(4);
    for (const int index : grains)
    {
        ++count[shapeAt(shapes, index).index()];
    }
    return count;
}

} // namespace

TEST(Composition, mixturesHaveTheirShares)
{
    const Composition composition{{{0, 50}, {1, 30}, {3, 20}}, {}};
    for (std::uint64_t seed = 1; seed < 20; ++seed)
    {
        RandomEngine engine(seed);
        std::vector<NamedShape> shapes = test::shapesOfEachKind(181);
        const std::vector<int> grains = composeNumber(shapes, composition, 1003, engine);
        EXPECT_EQ(grains.size(), 1003u);
        EXPECT_EQ(shapes.size(), 4u) << "no copies of shapes that keep their size";
        const std::vector<int> count = kinds(shapes, grains);
        EXPECT_NEAR(count[0], 501.5, 1);
        EXPECT_NEAR(count[1], 300.9, 1);
        EXPECT_EQ(count[2], 0);
        EXPECT_NEAR(count[3], 200.6, 1);
        // In any order: the first half is mixed too.
        const std::vector<int> half(grains.begin(), grains.begin() + 500);
        EXPECT_NEAR(kinds(shapes, half)[0], 250, 60);
    }
}

TEST(Composition, aSieveCurveIsReproducedByMass)
{
    const std::vector<double> sieves{0.002, 0.004, 0.0063, 0.012, 0.02};
    const std::vector<double> passing{0, 0.13, 0.41, 0.83, 1};
    const Composition composition{{{0, 1}, {1, 1}, {2, 1}, {3, 1}},
                                  sizeClasses(SieveCurve(sieves, passing), 32)};
    for (std::uint64_t seed = 1; seed < 20; ++seed)
    {
        RandomEngine engine(seed);
        std::vector<NamedShape> shapes = test::shapesOfEachKind(182);
        const std::vector<int> grains = composeNumber(shapes, composition, 10000, engine);
        const double whole = wholeArea(shapes, grains);
        for (std::size_t i = 0; i < sieves.size(); ++i)
        {
            double finer = 0;
            for (const int index : grains)
            {
                finer += diameterOf(shapes, index) < sieves[i] ? areaOf(shapes, index) : 0;
            }
            EXPECT_NEAR(finer / whole, passing[i], 0.01) << sieves[i];
        }
        EXPECT_NEAR(kinds(shapes, grains)[3], 2500, 1);
    }
}

TEST(Composition, lognormalSizesHaveTheirMedian)
{
    const LognormalSize sizes(0.01, 0.4, 0.002, 0.05);
    RandomEngine engine(3);
    std::vector<NamedShape> shapes = test::shapesOfEachKind(183);
    std::vector<double> diameters;
    for (const int index : composeNumber(shapes, {{{1, 1}, {3, 1}}, sizeClasses(sizes, 32)}, 1000, engine))
    {
        diameters.push_back(diameterOf(shapes, index));
    }
    std::sort(diameters.begin(), diameters.end());
    for (const int percent : {10, 25, 50, 75, 90})
    {
        // Half a class of 32 to either side.
        const double size = diameters[static_cast<std::size_t>(10 * percent)];
        EXPECT_GE(size, sizes.quantile(percent / 100.0 - 0.5 / 32));
        EXPECT_LE(size, sizes.quantile(percent / 100.0 + 0.5 / 32 + 0.002));
    }
}

TEST(Composition, ratiosMultiplyTheTemplatesOwnSize)
{
    RandomEngine engine(4);
    std::vector<NamedShape> shapes = test::shapesOfEachKind(184);
    const std::vector<int> grains =
        composeNumber(shapes, {{{0, 1}, {2, 1}}, sizeClasses(UniformRatio(0.5, 3), 8)}, 800, engine);
    std::vector<double> sums(3);
    for (const int index : grains)
    {
        const std::size_t kind = shapeAt(shapes, index).index();
        const double ratio = diameterOf(shapes, index) / diameterOf(shapes, static_cast<int>(kind));
        EXPECT_GE(ratio, 0.5);
        EXPECT_LE(ratio, 3);
        sums[kind] += ratio;
    }
    EXPECT_NEAR((sums[0] + sums[2]) / 800, 1.75, 0.01);
}

TEST(Composition, copiesAreSharedAndNamed)
{
    RandomEngine engine(5);
    std::vector<NamedShape> shapes = test::shapesOfEachKind(185);
    const SizeClasses sizes = sizeClasses(LognormalSize(0.01, 0.4, 0.002, 0.05), 5);
    const std::vector<int> grains = composeNumber(shapes, {{{1, 1}, {3, 1}}, sizes}, 2000, engine);
    EXPECT_EQ(shapes.size(), 4u + 10u);
    for (const int index : grains)
    {
        ASSERT_GE(index, 4);
    }
    EXPECT_THAT(shapes.back().name, HasSubstr(" of size 0.0"));
}

TEST(Composition, theAreaIsMetToTheSmallestGrain)
{
    const std::vector<SizeClasses> sizes{{},
                                         sizeClasses(UniformRatio(0.2, 1), 32),
                                         sizeClasses(LognormalSize(0.01, 0.8, 0.001, 0.1), 32),
                                         sizeClasses(SieveCurve({0.002, 0.1}, {0, 1}), 32)};
    for (const SizeClasses& some : sizes)
    {
        for (const double area : {0.01, 0.1, 1.0})
        {
            for (std::uint64_t seed = 1; seed < 10; ++seed)
            {
                RandomEngine engine(seed);
                std::vector<NamedShape> shapes = test::shapesOfEachKind(186);
                const std::vector<int> grains =
                    composeArea(shapes, {{{0, 1}, {1, 3}, {3, 1}}, some}, area, engine);
                double smallest = area;
                for (const int index : grains)
                {
                    smallest = std::min(smallest, areaOf(shapes, index));
                }
                EXPECT_NEAR(wholeArea(shapes, grains), area, smallest);
            }
        }
    }
}

TEST(Composition, theSeedDecides)
{
    const Composition composition{{{0, 1}, {3, 2}}, sizeClasses(UniformRatio(0.5, 3), 8)};
    const auto draw = [&](std::uint64_t seed)
    {
        RandomEngine engine(seed);
        std::vector<NamedShape> shapes = test::shapesOfEachKind(187);
        std::vector<double> areas;
        for (const int index : composeNumber(shapes, composition, 100, engine))
        {
            areas.push_back(areaOf(shapes, index));
        }
        return areas;
    };
    EXPECT_EQ(draw(1), draw(1));
    EXPECT_NE(draw(1), draw(2));
}

TEST(Composition, impossibleAreasAndSizesAreRefused)
{
    std::vector<NamedShape> shapes = test::shapesOfEachKind(188);
    RandomEngine engine(1);
    EXPECT_THROW(composeArea(shapes, {{{0, 1}}, {}}, 1e-9, engine), ValueError);
    EXPECT_THROW(composeArea(shapes, {{{0, 1}}, {}}, 1e30, engine), ValueError);
    EXPECT_THROW(composeNumber(shapes, {{{0, 1}}, sizeClasses(UniformRatio(1e80, 1e81), 8)}, 10, engine),
                 ValueError);
    EXPECT_TRUE(composeNumber(shapes, {{{0, 1}}, {}}, 0, engine).empty());
}
