#include "core/base/setupError.hpp"
#include "unit/core/world/pairFound.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

// Grains with straight sides in positions whose contact is known by formula, through pairContact and pairDistance.

using namespace chesil;
using test::expectContact;
using test::expectDepth;
using test::findPair;
using test::PairFound;
using test::rectangle;

namespace
{

constexpr double epsilon = tolerances::epsilon;

/// The same outline as a polygon and as a polybezier.
std::vector<Shape> bothKinds(const std::vector<Vector2>& vertices)
{
    return {ConvexPolygon(vertices), PolyBezier(test::polygonSegments(vertices))};
}

std::vector<Shape> squares() { return bothKinds(test::rectangleVertices(2, 2)); }

std::vector<Vector2> regular(int sides, double radius = 1)
{
    std::vector<Vector2> vertices;
    for (int i = 0; i < sides; ++i)
    {
        vertices.emplace_back(radius * std::cos(2 * M_PI * i / sides), radius * std::sin(2 * M_PI * i / sides));
    }
    return vertices;
}

} // namespace

TEST(KnownFlatPairs, squaresThatBarelyOverlap)
{
    for (const Shape& a : squares())
    {
        for (const Shape& b : squares())
        {
            expectContact(findPair(a, b, {2 - 1e-9, 0}), 2 - (2 - 1e-9), {1, 0}, 1e-14);
            expectContact(findPair(a, b, {2 - 1e-9, 2 - 2e-9}), 2 - (2 - 1e-9), {1, 0}, 1e-14);
            expectContact(findPair(a, b, {0, 1.9}), 2 - 1.9, {0, 1}, 1e-14);
            for (const double angle : {0.2, 1.5, 2.5, M_PI, -1.0})
            {
                const Vector2 elsewhere(std::cos(angle), std::sin(angle));
                const Pose<2> there{Vector2(2 - 1e-9, 2 - 2e-9), {}};
                expectContact(findPair(a, Pose<2>{}, b, there, SearchStart{elsewhere}), 2 - (2 - 1e-9), {1, 0}, 1e-14);
            }
        }
    }
}

TEST(KnownFlatPairs, aTieIsDecidedTheSameEachTime)
{
    for (const Shape& a : squares())
    {
        for (const Shape& b : squares())
        {
            const PairFound first = findPair(a, b, {1.5, 1.5});
            const PairFound second = findPair(a, b, {1.5, 1.5});
            expectDepth(first, 0.5);
            EXPECT_EQ(first.contact.depth, second.contact.depth);
            EXPECT_EQ(first.contact.normal, second.contact.normal);
            EXPECT_EQ(first.contact.point, second.contact.point);
            EXPECT_NEAR(std::abs(first.contact.normal.x() - first.contact.normal.y()), 1, 1e-14);
        }
    }
}

TEST(KnownFlatPairs, aSquareTurnedByVeryLittle)
{
    for (const Shape& a : squares())
    {
        for (const Shape& b : squares())
        {
            for (const double turn : {1e-15, 1e-12, -1e-12, 1e-9, -1e-6})
            {
                for (const double wanted : {1e-9, 1e-3, 0.3})
                {
                    const double distance = 2 - wanted;
                    const double depth = (1 - distance) + (std::sin(std::abs(turn)) + std::cos(turn));
                    SCOPED_TRACE("turn " + std::to_string(turn * 1e12) + "e-12, depth " + std::to_string(depth));
                    // One of the two faces is the contact's: A's with this depth, or B's, as deep to second order.
                    const PairFound found = findPair(a, b, {distance, 0}, turn);
                    const Pose<2> there{Vector2(distance, 0), Rotation<2>(turn)};
                    expectDepth(found, -static_cast<double>(test::preciseDistance(a, Pose<2>{}, b, there)));
                    EXPECT_NEAR(found.contact.depth, depth, found.allowed() + 4 * turn * turn);
                    EXPECT_LT((found.contact.normal - Vector2(1, 0)).norm(), 1.01 * std::abs(turn) + 1e-14);
                }
            }
        }
    }
}

TEST(KnownFlatPairs, aVertexOnAFace)
{
    for (const Shape& a : squares())
    {
        for (const Shape& b : squares())
        {
            for (const double wanted : {1e-12, 1e-6, 1e-3, 0.5})
            {
                const double distance = 1 + std::sqrt(2) - wanted;
                const double depth = static_cast<double>(1 + std::sqrt(2.0L) - distance);
                const PairFound found = findPair(a, b, {distance, 0}, M_PI / 4);
                expectContact(found, depth, {1, 0}, 1e-14);
                EXPECT_LT((found.contact.point - Vector2(1 - depth / 2, 0)).norm(), 1e-14);
            }
        }
    }
}

TEST(KnownFlatPairs, cornersThatFaceEachOtherAreApart)
{
    for (const Shape& a : squares())
    {
        for (const Shape& b : squares())
        {
            const PairFound found = findPair(a, b, {3, 3});
            EXPECT_EQ(found.status, PairStatus::separated);
            expectDepth(found, -std::sqrt(2.0));
            EXPECT_LT((found.apart.normal - Vector2(1, 1) / std::sqrt(2)).norm(), 1e-14);
            EXPECT_LT((found.apart.onA - Vector2(1, 1)).norm(), 1e-14);
            EXPECT_LT((found.apart.onB - Vector2(2, 2)).norm(), 1e-14);
        }
    }
}

TEST(KnownFlatPairs, crossedPlates)
{
    for (const Shape& a : bothKinds(test::rectangleVertices(1000, 1)))
    {
        for (const Shape& b : bothKinds(test::rectangleVertices(1000, 1)))
        {
            const PairFound found = findPair(a, b, {0, 0}, M_PI / 2);
            ASSERT_TRUE(found.overlaps());
            expectDepth(found, 500.5);
        }
    }
}

TEST(KnownFlatPairs, identicalPolygons)
{
    for (const Shape& a : bothKinds(test::rectangleVertices(3, 1)))
    {
        const PairFound found = findPair(a, a, {0, 0});
        ASSERT_TRUE(found.overlaps());
        expectDepth(found, 1);
        EXPECT_NEAR(std::abs(found.contact.normal.y()), 1, 1e-14);
    }
}

TEST(KnownFlatPairs, repeatedAndCollinearVerticesChangeNothing)
{
    const Shape clean = rectangle(2, 2);
    const Shape littered = ConvexPolygon(
        {{-1, -1}, {-1, -1}, {0, -1}, {0.5, -1}, {1, -1}, {1, 0}, {1, 1}, {1, 1}, {-1, 1}, {-1, 1}, {-1, 0.25}});
    const std::vector<Vector2> collinear{{-1, -1}, {0, -1}, {0.5, -1}, {1, -1}, {1, 0}, {1, 1}, {-1, 1}, {-1, 0.25}};
    for (const Shape& other : {littered, Shape(PolyBezier(test::polygonSegments(collinear)))})
    {
        for (const Vector2& offset : {Vector2(1.9, 0), Vector2(0, 1.9), Vector2(-1.5, 1.7), Vector2(-0.1, -1.99)})
        {
            for (const double angle : {0.0, 0.1})
            {
                const PairFound wanted = findPair(clean, clean, offset, angle);
                for (const PairFound& found :
                     {findPair(other, clean, offset, angle), findPair(clean, other, offset, angle), findPair(other, other, offset, angle)})
                {
                    expectContact(found, wanted.contact.depth, wanted.contact.normal, 1e-14);
                }
            }
        }
    }
}

TEST(KnownFlatPairs, aThousandSidesAndADisk)
{
    constexpr int sides = 1000;
    const double apothem = std::cos(M_PI / sides);
    const Vector2 outward(std::cos(M_PI / sides), std::sin(M_PI / sides));
    for (const Shape& grain : bothKinds(regular(sides)))
    {
        for (const Shape& disk : {Shape(Circle(0.5)), Shape(Ellipse(0.5, 0.5))})
        {
            for (const double wanted : {1e-9, 1e-6, 1e-3, 0.3})
            {
                const Vector2 centre = (apothem + 0.5 - wanted) * outward;
                SCOPED_TRACE("depth " + std::to_string(wanted) + ", kinds " + std::to_string(grain.index()) + ' ' + std::to_string(disk.index()));
                const PairFound found = findPair(grain, disk, centre);
                expectDepth(found, wanted);
                // By separating axes, wherever the disk is.
                test::RandomSource random(712);
                for (int i = 0; i < 3; ++i)
                {
                    const Pose<2> there{(1.5 - wanted) * random.direction(), {}};
                    expectDepth(
                        findPair(grain, Pose<2>{}, disk, there),
                        -static_cast<double>(test::preciseDistance(grain, Pose<2>{}, disk, there, 4000)));
                }
            }
        }
    }
}

TEST(KnownFlatPairs, aPolyBezierOfStraightEdgesIsThePolygon)
{
    test::RandomSource random(711);
    int contacts = 0;
    for (int i = 0; i < 2000; ++i)
    {
        const ConvexPolygon a = test::randomPolygon(random.integer(3, 8), 1, random);
        const ConvexPolygon b = test::randomPolygon(random.integer(3, 8), 1, random);
        const PolyBezier curvedA(test::polygonSegments(a.vertices()));
        const PolyBezier curvedB(test::polygonSegments(b.vertices()));
        const Pose<2> poseA = random.pose(1);
        const Pose<2> poseB = random.pose(1);
        const PairFound wanted = findPair(a, poseA, b, poseB);
        const PairFound found = findPair(curvedA, poseA, curvedB, poseB);
        SCOPED_TRACE(i);
        ASSERT_EQ(found.status, wanted.status);
        contacts += found.overlaps() ? 1 : 0;
        EXPECT_NEAR(found.contact.depth, wanted.contact.depth, 1e-15 * found.size);
        EXPECT_NEAR(found.apart.distance, wanted.apart.distance, 1e-15 * found.size);
    }
    EXPECT_GT(contacts, 500);
}

TEST(KnownFlatPairs, flatFaceToFlatFace)
{
    const std::vector<Shape> tiles{rectangle(2, 2), PolyBezier(test::polygonSegments(test::rectangleVertices(2, 2))), test::roundedSquare(2, 0.25)};
    for (const Shape& a : tiles)
    {
        for (const Shape& b : tiles)
        {
            for (const double wanted : {1e-15, 1e-12, 1e-9, 1e-4, 0.1})
            {
                for (const double aside : {0.0, 0.3, -1.2})
                {
                    const double distance = 2 - wanted;
                    const PairFound found = findPair(a, b, {aside, distance});
                    expectContact(found, 2 - distance, {0, 1}, 1e-14);
                }
            }
        }
    }
    // Turned together: any angle.
    test::RandomSource random(713);
    for (int i = 0; i < 200; ++i)
    {
        const Rotation<2> turn(random.uniform(-M_PI, M_PI));
        const double depth = random.logUniform(1e-12, 0.1);
        const Pose<2> there{turn.apply(Vector2(random.uniform(-1, 1), 2 - depth)), turn};
        const PairFound found = findPair(tiles[0], {Vector2::Zero(), turn}, tiles[2], there);
        expectContact(found, depth, turn.apply(Vector2(0, 1)), 1e-14);
    }
    EXPECT_EQ(findPair(tiles[0], tiles[0], {0.3, 2 + 4 * epsilon}).status, PairStatus::separated);
}
