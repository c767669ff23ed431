#include "core/base/setupError.hpp"
#include "core/broadphase/neighbourSearch.hpp"
#include "core/world/composition.hpp"
#include "core/world/pairDistance.hpp"
#include "core/world/randomInsertion.hpp"
#include "unit/core/world/worldScenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>

using namespace chesil;
using testing::HasSubstr;

namespace
{

const PlacementBox box{Vector2(-1, 2), Vector2(0, 3)};

struct Packing
{
    std::vector<NamedShape> shapes;
    std::vector<GrainState> grains;

    const Shape& shapeOf(const GrainState& grain) const
    {
        return shapes[static_cast<std::size_t>(grain.shape)].shape;
    }

    double area() const
    {
        double sum = 0;
        for (const GrainState& grain : grains)
        {
            sum += massProperties(shapeOf(grain)).area;
        }
        return sum;
    }
};

/// Grains of the composition that fill a share of the unit box.
Packing fill(std::vector<NamedShape> shapes, const Composition& composition, double share, double gap,
             std::uint64_t seed)
{
    RandomEngine engine(seed);
    Packing result{std::move(shapes), {}};
    const std::vector<int> shapeOfGrain = composeArea(result.shapes, composition, share, engine);
    result.grains = insertAtRandom(result.shapes, shapeOfGrain, box, gap, engine);
    return result;
}

/// About `number` disks that fill a share of the unit box; the least processor time [s] of three runs.
Packing fillWithDisks(int number, double share, SizeClasses sizes, double& time)
{
    double meanSquare = 0;
    for (const SizeClass& one : sizes.classes)
    {
        meanSquare += one.share * one.size * one.size;
    }
    for (SizeClass& one : sizes.classes)
    {
        one.size *= std::sqrt(share * 4 / M_PI / number / meanSquare);
    }
    time = std::numeric_limits<double>::infinity();
    Packing result;
    for (int run = 0; run < 3; ++run)
    {
        const std::clock_t start = std::clock();
        result = fill({{"disk", Circle(1)}}, {{{0, 1}}, sizes}, share, 0, 1);
        time = std::min(time, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return result;
}

/// Outlines within the box, and no two nearer than the gap, by the exact distance of all near pairs.
void expectApartAndInside(const Packing& packing, double gap)
{
    std::vector<Vector2> positions;
    std::vector<double> radii;
    for (const GrainState& grain : packing.grains)
    {
        const Shape& shape = packing.shapeOf(grain);
        const Pose<2> pose{grain.position, Rotation<2>(grain.angle)};
        for (const Vector2& point : outlinePoints(placed(outline(shape), pose), 1e-4))
        {
            EXPECT_TRUE(((point - box.lower).array() >= -1e-14).all() &&
                        ((box.upper - point).array() >= -1e-14).all());
        }
        positions.push_back(grain.position);
        radii.push_back(boundingRadius(shape));
    }
    std::vector<Vector2> halfExtents;
    for (const double radius : radii)
    {
        halfExtents.emplace_back(radius, radius);
    }
    NeighbourSearch search;
    for (const PairKey& pair : search.find(positions, halfExtents, radii, gap))
    {
        const GrainState& a = packing.grains[static_cast<std::size_t>(pair.first)];
        const GrainState& b = packing.grains[static_cast<std::size_t>(pair.second)];
        const PairDistance found = pairDistance(packing.shapeOf(a), {a.position, Rotation<2>(a.angle)},
                                                packing.shapeOf(b), {b.position, Rotation<2>(b.angle)});
        ASSERT_EQ(found.status, PairStatus::separated) << pair.first << ' ' << pair.second;
        ASSERT_GE(found.distance, gap * (1 - 1e-9)) << pair.first << ' ' << pair.second;
    }
}

std::string refusal(const PlacementBox& where, double gap, int number = 1, double radius = 0.1)
{
    RandomEngine engine(1);
    try
    {
        insertAtRandom({{"ball", Circle(radius)}}, std::vector<int>(static_cast<std::size_t>(number)), where,
                       gap, engine);
    }
    catch (const ValueError& error)
    {
        EXPECT_NE(error.expected(), "");
        return error.found();
    }
    ADD_FAILURE() << "not refused";
    return "";
}

} // namespace

TEST(RandomInsertion, grainsOfAllKindsStayApartAndInside)
{
    const Composition composition{{{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {}};
    for (std::uint64_t seed = 1; seed < 6; ++seed)
    {
        for (const double gap : {0.0, 0.01})
        {
            const Packing packing =
                fill(test::shapesOfEachKind(191), composition, gap > 0 ? 0.3 : 0.45, gap, seed);
            EXPECT_GT(packing.grains.size(), 100u);
            expectApartAndInside(packing, gap);
        }
    }
}

TEST(RandomInsertion, aRatioOfSizesOfFifty)
{
    const Composition composition{{{0, 1}, {1, 1}, {3, 1}},
                                  sizeClasses(SieveCurve({0.004, 0.2}, {0, 1}), 32)};
    const Packing packing = fill(test::shapesOfEachKind(192), composition, 0.6, 0, 1);
    EXPECT_GT(packing.grains.size(), 1000u);
    EXPECT_NEAR(packing.area(), 0.6, 0.0001);
    expectApartAndInside(packing, 0);
}

TEST(RandomInsertion, slenderGrainsComeNearTheSides)
{
    // Wider than the box is high: only angles at which they fit.
    RandomEngine engine(1);
    const PlacementBox low{Vector2(0, 0), Vector2(10, 0.1)};
    const std::vector<NamedShape> shapes{{"needle", Ellipse(0.2, 0.01)}};
    for (const GrainState& grain : insertAtRandom(shapes, std::vector<int>(20), low, 0, engine))
    {
        EXPECT_LT(std::abs(std::sin(grain.angle)), 0.26);
    }
}

TEST(RandomInsertion, placesAndAnglesAreEven)
{
    // Few small disks, so that none is in the way: mean and spread of a uniform distribution.
    RandomEngine engine(2);
    const std::vector<NamedShape> shapes{{"grit", Circle(1e-5)}};
    const std::vector<GrainState> grains = insertAtRandom(shapes, std::vector<int>(10000), box, 0, engine);
    Vector2 sum = Vector2::Zero();
    Vector2 squares = Vector2::Zero();
    double angles = 0;
    for (const GrainState& grain : grains)
    {
        const Vector2 local = grain.position - box.lower;
        sum += local;
        squares += local.cwiseProduct(local);
        angles += grain.angle;
    }
    EXPECT_LT((sum / 10000 - Vector2(0.5, 0.5)).norm(), 0.015);
    EXPECT_LT((squares / 10000 - Vector2(1, 1) / 3).norm(), 0.015);
    EXPECT_NEAR(angles / 10000, M_PI, 0.06);
}

TEST(RandomInsertion, theSeedDecides)
{
    const Composition composition{{{1, 1}, {3, 1}}, sizeClasses(UniformRatio(0.3, 1), 8)};
    const auto hash = [&](std::uint64_t seed)
    {
        const Packing packing = fill(test::shapesOfEachKind(193), composition, 0.4, 0.001, seed);
        WorldSettings settings = test::quartzSettings();
        settings.shapes = packing.shapes;
        settings.grains = packing.grains;
        return test::hashOf(World(settings));
    };
    EXPECT_EQ(hash(1), hash(1));
    EXPECT_NE(hash(1), hash(2));
}

TEST(RandomInsertion, timeIsNearlyLinear)
{
    // Sizes, up to a factor that gives the number wanted.
    const std::pair<const char*, SizeClasses> kinds[]{
        {"equal", {{{1, 1}}, false}}, {"1:50", sizeClasses(SieveCurve({0.001, 0.05}, {0, 1}), 32)}};
    for (const auto& [name, sizes] : kinds)
    {
        double last = std::numeric_limits<double>::infinity();
        for (const int number : {1000, 10000})
        {
            double time = 0;
            const Packing packing = fillWithDisks(number, 0.5, sizes, time);
            std::printf("%s disks: %zu in %.4f s\n", name, packing.grains.size(), time);
            EXPECT_NEAR(static_cast<double>(packing.grains.size()), number, 0.05 * number);
            EXPECT_NEAR(packing.area(), 0.5, 1.0 / number);
            expectApartAndInside(packing, 0);
            // Ten times as many; quadratic would be a hundred.
            EXPECT_LT(time, 40 * last);
            last = time;
        }
    }
}

TEST(RandomInsertion, refusesAFullBox)
{
    // Disks of radius 0.1 inserted at random fill little more than half of any box: 22 would be 0.69.
    const std::string found = refusal(box, 0, 22);
    EXPECT_THAT(found, HasSubstr("no place for grain ball in 100000 tries, with 1"));
    EXPECT_THAT(found, HasSubstr("of 22 grains placed, which fill 0."));
    EXPECT_THAT(refusal(box, 0, 1, 0.6), HasSubstr("with 0 of 1 grains placed, which fill 0 of the box"));
    EXPECT_THAT(refusal(box, 2, 2), HasSubstr("with 1 of 2 grains placed"));
}

TEST(RandomInsertion, refusesImpossibleBoxesAndGaps)
{
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_THAT(refusal({box.upper, box.lower}, 0), HasSubstr("a box of -1 x -1 m"));
    EXPECT_THAT(refusal({box.lower, box.lower}, 0), HasSubstr("a box of 0 x 0 m"));
    EXPECT_THAT(refusal({box.lower, Vector2(infinite, 3)}, 0), HasSubstr("a box of inf"));
    EXPECT_THAT(refusal(box, -1e-3), HasSubstr("a gap of -0.001 m"));
    EXPECT_THAT(refusal(box, std::numeric_limits<double>::quiet_NaN()), HasSubstr("a gap of"));
}
