#include "core/base/setupError.hpp"
#include "unit/core/world/worldScenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace chesil;
using testing::HasSubstr;

namespace
{

const PlacementBox box{Vector2(-1, 2), Vector2(-0.4, 4)};

std::string refusal(const std::vector<NamedShape>& shapes, int number, const PlacementBox& where)
{
    try
    {
        placeOnLattice(shapes, {0}, number, where, 1);
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

TEST(Placement, grainsStayInTheBoxAndApart)
{
    const std::vector<NamedShape> shapes = test::shapesOfEachKind(171);
    for (std::uint64_t seed = 1; seed < 20; ++seed)
    {
        const std::vector<GrainState> grains = placeOnLattice(shapes, {0, 1, 2, 3}, 200, box, seed);
        ASSERT_EQ(grains.size(), 200u);
        const auto radiusOf = [&](const GrainState& grain)
        { return boundingRadius(shapes[static_cast<std::size_t>(grain.shape)].shape); };
        for (std::size_t i = 0; i < grains.size(); ++i)
        {
            const double radius = radiusOf(grains[i]) * (1 - 1e-12);
            EXPECT_GE(grains[i].position.x() - radius, box.lower.x());
            EXPECT_GE(grains[i].position.y() - radius, box.lower.y());
            EXPECT_LE(grains[i].position.x() + radius, box.upper.x());
            EXPECT_LE(grains[i].position.y() + radius, box.upper.y());
            for (std::size_t j = 0; j < i; ++j)
            {
                EXPECT_GE((grains[i].position - grains[j].position).norm(),
                          radius + radiusOf(grains[j]) * (1 - 1e-12));
            }
        }
    }
}

TEST(Placement, usesTheChosenShapesAndNoOthers)
{
    const std::vector<NamedShape> shapes = test::shapesOfEachKind(172);
    std::array<int, 4> count{};
    for (const GrainState& grain : placeOnLattice(shapes, {1, 3}, 200, box, 5))
    {
        ++count[static_cast<std::size_t>(grain.shape)];
    }
    EXPECT_EQ(count[0] + count[2], 0);
    EXPECT_GT(count[1], 60);
    EXPECT_GT(count[3], 60);
}

TEST(Placement, theSeedDecides)
{
    const std::vector<NamedShape> shapes = test::shapesOfEachKind(173);
    const auto angles = [&](std::uint64_t seed)
    {
        std::vector<double> result;
        for (const GrainState& grain : placeOnLattice(shapes, {0, 1, 2, 3}, 50, box, seed))
        {
            result.push_back(grain.angle);
        }
        return result;
    };
    EXPECT_EQ(angles(7), angles(7));
    EXPECT_NE(angles(7), angles(8));
    // The same numbers on any machine: the first one of mt19937_64 with seed 1 chooses the shape, the second
    // turns.
    EXPECT_DOUBLE_EQ(angles(1)[0],
                     2 * M_PI * static_cast<double>(std::uint64_t{2516265689700432462u} >> 11) * 0x1p-53);
}

TEST(Placement, refusesGrainsThatAreTooBig)
{
    const std::vector<NamedShape> shapes{{"boulder", Circle(0.4)}};
    EXPECT_THAT(refusal(shapes, 1, box), HasSubstr("grain boulder, 0.8 m wide"));
    EXPECT_THAT(refusal(shapes, 1, {Vector2(0, 0), Vector2(10, 0.5)}), HasSubstr("boulder"));
}

TEST(Placement, refusesMoreGrainsThanPlaces)
{
    const std::vector<NamedShape> shapes{{"ball", Circle(0.0999)}};
    EXPECT_EQ(placeOnLattice(shapes, {0}, 30, box, 1).size(), 30u);
    EXPECT_THAT(refusal(shapes, 31, box), HasSubstr("31 grains in a box with 3 x 10 places"));
}

TEST(Placement, noneIsNone)
{
    EXPECT_TRUE(placeOnLattice(test::shapesOfEachKind(174), {0}, 0, box, 1).empty());
}

TEST(Placement, numbersByPlaceAreNearWhereGrainsAre)
{
    test::RandomSource random(175);
    std::vector<GrainState> grains(2000);
    double sum = 0;
    for (GrainState& grain : grains)
    {
        grain.position = Vector2(random.uniform(-3, 1), random.uniform(5, 6));
        sum += grain.position.x();
    }
    numberByPlace(grains);
    double sumAfter = 0;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        sumAfter += grains[i].position.x();
        for (std::size_t j = i + 1; j < grains.size(); ++j)
        {
            // Rows of 89 grains, 0.045 m high: a grain this near is in the same row or the next one.
            if ((grains[i].position - grains[j].position).norm() < 0.03)
            {
                EXPECT_LT(j - i, 2u * 89 + 40);
            }
        }
    }
    EXPECT_NEAR(sumAfter, sum, 1e-9);
    std::vector<GrainState> none;
    numberByPlace(none);
    std::vector<GrainState> stacked(3);
    numberByPlace(stacked);
    EXPECT_EQ(stacked.size(), 3u);
}
