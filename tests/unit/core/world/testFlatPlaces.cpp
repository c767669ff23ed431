#include "core/world/flatContact.hpp"
#include "core/world/wallContact.hpp"
#include "unit/core/world/pairFound.hpp"
#include "unit/knownShapes.hpp"

#include <gtest/gtest.h>

// The two places of a flat contact: where they are, how deep, and that springs there conserve energy.

using namespace chesil;
using test::findPair;
using test::PairFound;
using test::rectangle;

namespace
{

using Places = std::array<ContactGeometry<2>, 2>;

std::vector<Shape> tiles()
{
    return {rectangle(2, 2), PolyBezier(test::polygonSegments(test::rectangleVertices(2, 2)))};
}

struct Flat
{
    bool overlap = false;
    bool two = false;
    Places places;
};

Flat flat(const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB)
{
    Flat result;
    SearchStart start;
    ContactGeometry<2> contact{};
    result.overlap = pairContact(a, poseA, b, poseB, start, contact) == PairStatus::overlapping;
    result.two = result.overlap && flatContact(a, poseA, b, poseB, contact, result.places);
    return result;
}

double energy(const Shape& a, const Shape& b, const Vector2& position, double angle)
{
    const Flat found = flat(a, Pose<2>{}, b, {position, Rotation<2>(angle)});
    double sum = 0;
    for (const ContactGeometry<2>& place : found.places)
    {
        sum += found.two && place.depth > 0 ? place.depth * place.depth / 2 : 0;
    }
    return sum;
}

} // namespace

TEST(FlatPlaces, equalSquaresFaceToFace)
{
    for (const Shape& a : tiles())
    {
        for (const Shape& b : tiles())
        {
            for (const double wanted : {1e-12, 1e-6, 1e-2})
            {
                const double depth = 2 - (2 - wanted);
                const Flat found = flat(a, Pose<2>{}, b, {Vector2(0, 2 - wanted), {}});
                ASSERT_TRUE(found.two);
                EXPECT_NEAR(found.places[0].depth, depth, 1e-15);
                EXPECT_NEAR(found.places[1].depth, depth, 1e-15);
                EXPECT_LT((found.places[0].normal - Vector2(0, 1)).norm(), 1e-15);
                EXPECT_LT((found.places[0].point - Vector2(1, 1 - depth / 2)).norm(), 1e-14) << "first in perpendicular(normal)";
                EXPECT_LT((found.places[1].point - Vector2(-1, 1 - depth / 2)).norm(), 1e-14);
            }
        }
    }
}

TEST(FlatPlaces, squaresStaggeredByHalf)
{
    for (const Shape& a : tiles())
    {
        for (const Shape& b : tiles())
        {
            for (const double aside : {1.0, -1.0, 0.25})
            {
                const Flat found = flat(a, Pose<2>{}, b, {Vector2(aside, 2 - 1e-3), {}});
                ASSERT_TRUE(found.two);
                EXPECT_NEAR(found.places[0].depth, 1e-3, 1e-15);
                EXPECT_NEAR(found.places[1].depth, 1e-3, 1e-15);
                const Vector2 middle = (found.places[0].point + found.places[1].point) / 2;
                EXPECT_LT((middle - Vector2(aside / 2, 1 - 5e-4)).norm(), 1e-14);
                EXPECT_NEAR((found.places[0].point - found.places[1].point).norm(), 2 - std::abs(aside), 1e-14);
            }
        }
    }
}

TEST(FlatPlaces, aTiltedSquareBothWays)
{
    constexpr double depth = 1e-3;
    for (const Shape& a : tiles())
    {
        for (const Shape& b : tiles())
        {
            for (double tilt = 1e-16; tilt <= 0.1; tilt *= 10)
            {
                for (const double angle : {tilt, -tilt})
                {
                    for (const double aside : {0.0, 0.3, -0.7})
                    {
                        SCOPED_TRACE("angle " + std::to_string(angle * 1e12) + "e-12, aside " + std::to_string(aside));
                        // Lifted so that the depth at the middle of B's side stays.
                        const Flat found = flat(a, Pose<2>{}, b, {Vector2(aside, 1 + std::cos(angle) - depth), Rotation<2>(angle)});
                        ASSERT_TRUE(found.two);
                        // Along B's lower side, at the right and the left end of the shared length.
                        const double right = std::min(1.0, aside + 1);
                        const double left = std::max(-1.0, aside - 1);
                        const double atRight = depth - std::tan(angle) * (right - aside);
                        const double atLeft = depth - std::tan(angle) * (left - aside);
                        EXPECT_NEAR(found.places[0].depth, atRight, 2 * angle * angle + 1e-14);
                        EXPECT_NEAR(found.places[1].depth, atLeft, 2 * angle * angle + 1e-14);
                    }
                }
            }
        }
    }
}

TEST(FlatPlaces, depthsAreContinuousInTheTilt)
{
    for (const Shape& a : tiles())
    {
        for (const double aside : {0.0, 0.3, -0.7})
        {
            double before[2] = {0, 0};
            constexpr double step = 1e-5;
            for (int i = -2000; i <= 2000; ++i)
            {
                const Flat found = flat(a, Pose<2>{}, a, {Vector2(aside, 2 - 1e-2), Rotation<2>(i * step)});
                ASSERT_TRUE(found.two) << i;
                for (std::size_t k = 0; k < 2; ++k)
                {
                    if (i > -2000)
                    {
                        ASSERT_LT(std::abs(found.places[k].depth - before[k]), 2.1 * step) << i << ' ' << k;
                    }
                    before[k] = found.places[k].depth;
                }
            }
        }
    }
}

TEST(FlatPlaces, springsThereConserveEnergy)
{
    // Force and torque on B are minus the gradient of the sum of squares of the depths.
    constexpr double step = 1e-6;
    constexpr double depth = 1e-2;
    double worst = 0;
    for (const Shape& a : tiles())
    {
        for (const Shape& b : tiles())
        {
            for (const double aside : {0.0, 0.3, -0.7})
            {
                for (const double angle : {0.0, 1e-12, -1e-9, 1e-6, 1e-4, -1e-3, 3e-3, 0.05, -0.1})
                {
                    SCOPED_TRACE("angle " + std::to_string(angle) + ", aside " + std::to_string(aside));
                    const Vector2 position(aside, 2 - depth);
                    const Flat found = flat(a, Pose<2>{}, b, {position, Rotation<2>(angle)});
                    ASSERT_TRUE(found.two);
                    Vector2 force = Vector2::Zero();
                    double torque = 0;
                    double size = 0;
                    for (const ContactGeometry<2>& place : found.places)
                    {
                        const Vector2 push = std::max(0.0, place.depth) * place.normal;
                        force += push;
                        torque += cross(place.point - position, push);
                        size += push.norm();
                    }
                    const auto slope = [&](const Vector2& move, double turn)
                    {
                        return (energy(a, b, position + step * move, angle + step * turn)
                                - energy(a, b, position - step * move, angle - step * turn))
                            / (2 * step);
                    };
                    const double offX = std::abs(force.x() + slope({1, 0}, 0)) / size;
                    const double offY = std::abs(force.y() + slope({0, 1}, 0)) / size;
                    const double offTurn = std::abs(torque + slope({0, 0}, 1)) / size;
                    EXPECT_LT(offX, 1e-6);
                    EXPECT_LT(offY, 1e-6);
                    EXPECT_LT(offTurn, 1e-6);
                    worst = std::max({worst, offX, offY, offTurn});
                }
            }
        }
    }
    RecordProperty("worst", std::to_string(worst));
}

TEST(FlatPlaces, onAWall)
{
    const PlaneWall<2> wall{"floor", Vector2(0, 0), Vector2(0, 1)};
    for (const Shape& tile : tiles())
    {
        for (const double angle : {0.0, 1e-12, -1e-9, 1e-4, -1e-3})
        {
            const Pose<2> pose{Vector2(0.3, 1 - 1e-3), Rotation<2>(angle)};
            ContactGeometry<2> contact{};
            SearchStart start;
            ASSERT_TRUE(wallContact(tile, pose, wall, start, contact));
            Places places;
            ASSERT_TRUE(flatContact(tile, pose, wall, contact, places));
            for (std::size_t k = 0; k < 2; ++k)
            {
                // The normal points into the wall: the first place is on the left.
                const Vector2 corner = pose.toWorld(Vector2(k == 0 ? 1 : -1, -1));
                const Vector2 other = pose.toWorld(Vector2(k == 0 ? -1 : 1, -1));
                const bool right = (places[k].point - corner).norm() < (places[k].point - other).norm();
                const Vector2 nearest = right ? corner : other;
                EXPECT_NEAR(places[k].depth, -wall.distance(nearest), 1e-15);
                EXPECT_LT((places[k].point - nearest - places[k].depth / 2 * wall.normal).norm(), 1e-15);
                EXPECT_EQ(places[k].normal, Vector2(0, -1));
            }
            EXPECT_GT((places[1].point - places[0].point).dot(perpendicular(contact.normal)), 1.9);
        }
    }
}

TEST(FlatPlaces, swappedTheyAreTheSamePlaces)
{
    for (const double angle : {0.0, 1e-9, 1e-3, -2e-3})
    {
        const Shape tile = rectangle(2, 2);
        const Pose<2> there{Vector2(0.4, 2 - 1e-2), Rotation<2>(angle)};
        const Flat one = flat(tile, Pose<2>{}, tile, there);
        const Flat other = flat(tile, there, tile, Pose<2>{});
        ASSERT_TRUE(one.two && other.two);
        for (std::size_t k = 0; k < 2; ++k)
        {
            // In the order of perpendicular(normal), which is the other way round.
            const ContactGeometry<2>& same = other.places[1 - k];
            EXPECT_NEAR(one.places[k].depth, same.depth, 1e-14);
            EXPECT_LT((one.places[k].point - same.point).norm(), 1e-14);
            EXPECT_LT((one.places[k].normal + same.normal).norm(), 1e-14);
        }
    }
}

TEST(FlatPlaces, roundShapesHaveNone)
{
    EXPECT_FALSE(hasStraightSides(Circle(1)));
    EXPECT_FALSE(hasStraightSides(Ellipse(1, 2)));
    EXPECT_FALSE(hasStraightSides(PolyBezier(test::ellipseSegments(8, 1, 2))));
    EXPECT_TRUE(hasStraightSides(test::roundedSquare(2, 0.3)));
    EXPECT_TRUE(hasStraightSides(rectangle(1, 2)));
    EXPECT_FALSE(flat(rectangle(2, 2), Pose<2>{}, Circle(1), {Vector2(0, 1.9), {}}).two);
}
