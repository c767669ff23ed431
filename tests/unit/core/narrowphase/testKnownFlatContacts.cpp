#include "core/shapes/circle.hpp"
#include "unit/core/narrowphase/pairQuery.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

// Shapes with flat sides in positions whose depth is known by formula. EPA ends exactly on a face of A - B,
// so that only rounding is left.

using namespace chesil;
using test::query;
using test::rectangle;

namespace
{

/// Some roundings of a support difference.
constexpr double rounding = 2 * tolerances::supportRounding;

void expectContact(const test::PairAnswer& answer, double depth, const Vector2& normal)
{
    ASSERT_TRUE(answer.overlaps());
    EXPECT_EQ(answer.epaStatus, EpaStatus::converged);
    EXPECT_NEAR(answer.depth, depth, rounding * answer.size);
    EXPECT_LT((answer.normal - normal).norm(), rounding);
}

/// A needle without width: what the support contract takes, though no grain is one.
struct Segment
{
    Vector2 half;

    Vector2 support(const Vector2& direction) const
    {
        return direction.dot(half) >= 0 ? half : Vector2(-half);
    }
    double boundingRadius() const { return half.norm(); }
};

} // namespace

TEST(KnownFlatContacts, squaresThatBarelyOverlap)
{
    const ConvexPolygon square = rectangle(2, 2);
    expectContact(query(square, square, {2 - 1e-9, 0}), 2 - (2 - 1e-9), {1, 0});
    expectContact(query(square, square, {2 - 1e-9, 2 - 2e-9}), 2 - (2 - 1e-9), {1, 0});
    expectContact(query(square, square, {0, 1.9}), 2 - 1.9, {0, 1});
}

TEST(KnownFlatContacts, aTieIsDecidedTheSameEachTime)
{
    const ConvexPolygon square = rectangle(2, 2);
    const test::PairAnswer first = query(square, square, {1.5, 1.5});
    const test::PairAnswer second = query(square, square, {1.5, 1.5});
    EXPECT_NEAR(first.depth, 0.5, rounding * first.size);
    EXPECT_EQ(first.normal, second.normal);
    EXPECT_EQ(first.point, second.point);
}

TEST(KnownFlatContacts, aSquareTurnedByVeryLittle)
{
    const ConvexPolygon square = rectangle(2, 2);
    const double turn = 1e-12;
    const double distance = 2 - 1e-3;
    expectContact(query(square, square, {distance, 0}, turn),
                  (1 + std::sin(turn) + std::cos(turn)) - distance, {1, 0});
}

TEST(KnownFlatContacts, aVertexOnAFace)
{
    const ConvexPolygon square = rectangle(2, 2);
    for (const double depth : {1e-6, 1e-3, 0.5})
    {
        const test::PairAnswer answer = query(square, square, {1 + std::sqrt(2) - depth, 0}, M_PI / 4);
        expectContact(answer, depth, {1, 0});
        EXPECT_LT((answer.point - Vector2(1 - depth / 2, 0)).norm(), rounding * answer.size);
    }
}

TEST(KnownFlatContacts, cornersThatFaceEachOtherAreApart)
{
    const ConvexPolygon square = rectangle(2, 2);
    const test::PairAnswer answer = query(square, square, {3, 3});
    EXPECT_EQ(answer.status, GjkStatus::separated);
}

TEST(KnownFlatContacts, crossedPlates)
{
    const test::PairAnswer answer = query(rectangle(1000, 1), rectangle(1000, 1), {0, 0}, M_PI / 2);
    ASSERT_TRUE(answer.overlaps());
    EXPECT_NEAR(answer.depth, 500.5, rounding * answer.size);
}

TEST(KnownFlatContacts, needles)
{
    // Crossed: the difference is the square of side 2 around the origin.
    const test::PairAnswer crossed = query(Segment{{1, 0}}, Segment{{0, 1}}, {0, 0});
    ASSERT_TRUE(crossed.overlaps());
    EXPECT_NEAR(crossed.depth, 1, rounding * crossed.size);
    // Collinear: no depth, and a normal across if there is one.
    const test::PairAnswer collinear = query(Segment{{1, 0}}, Segment{{1, 0}}, {0.5, 0});
    EXPECT_NE(collinear.status, GjkStatus::iterationLimit);
    EXPECT_NEAR(collinear.depth, 0, rounding * collinear.size);
    if (collinear.overlaps())
    {
        EXPECT_NEAR(std::abs(collinear.normal.y()), 1, rounding);
    }
}

TEST(KnownFlatContacts, identicalPolygons)
{
    const ConvexPolygon plate = rectangle(3, 1);
    const test::PairAnswer answer = query(plate, plate, {0, 0});
    ASSERT_TRUE(answer.overlaps());
    EXPECT_NEAR(answer.depth, 1, rounding * answer.size);
    EXPECT_NEAR(std::abs(answer.normal.y()), 1, rounding);
}

TEST(KnownFlatContacts, repeatedAndCollinearVerticesChangeNothing)
{
    const ConvexPolygon clean = rectangle(2, 2);
    const ConvexPolygon littered({{-1, -1},
                                  {-1, -1},
                                  {0, -1},
                                  {0.5, -1},
                                  {1, -1},
                                  {1, 0},
                                  {1, 1},
                                  {1, 1},
                                  {-1, 1},
                                  {-1, 1},
                                  {-1, 0.25}});
    for (const Vector2& offset : {Vector2(1.9, 0), Vector2(0, 1.9), Vector2(-1.5, 1.7), Vector2(-0.1, -1.99)})
    {
        const test::PairAnswer wanted = query(clean, clean, offset);
        expectContact(query(littered, clean, offset), wanted.depth, wanted.normal);
        expectContact(query(clean, littered, offset), wanted.depth, wanted.normal);
        expectContact(query(littered, littered, offset), wanted.depth, wanted.normal);
    }
}

TEST(KnownFlatContacts, aThousandSidesAndACircle)
{
    constexpr int sides = 1000;
    std::vector<Vector2> vertices;
    for (int i = 0; i < sides; ++i)
    {
        vertices.emplace_back(std::cos(2 * M_PI * i / sides), std::sin(2 * M_PI * i / sides));
    }
    const ConvexPolygon polygon(vertices);
    const double apothem = std::cos(M_PI / sides);
    // Towards the middle of a side: no other direction is shallower, since the circle is round.
    const Vector2 outward(std::cos(M_PI / sides), std::sin(M_PI / sides));
    for (const double depth : {1e-6, 1e-3, 0.3})
    {
        const test::PairAnswer answer = query(polygon, Circle(0.5), (apothem + 0.5 - depth) * outward);
        ASSERT_TRUE(answer.overlaps());
        EXPECT_NEAR(answer.depth, depth, answer.depthError);
    }
}

TEST(KnownFlatContacts, aPolyBezierOfStraightEdgesIsThePolygon)
{
    test::RandomSource random(81);
    int contacts = 0;
    for (int i = 0; i < 200; ++i)
    {
        const ConvexPolygon a = test::randomPolygon(random.integer(3, 8), 1, random);
        const ConvexPolygon b = test::randomPolygon(random.integer(3, 8), 1, random);
        const PolyBezier curvedA(test::polygonSegments(a.vertices()));
        const PolyBezier curvedB(test::polygonSegments(b.vertices()));
        const Pose<2> poseA = random.pose(1);
        const Pose<2> poseB = random.pose(1);
        const test::PairAnswer wanted = query(a, poseA, b, poseB);
        const test::PairAnswer answer = query(curvedA, poseA, curvedB, poseB);
        ASSERT_EQ(answer.overlaps(), wanted.overlaps());
        EXPECT_NEAR(answer.depth, wanted.depth, rounding * wanted.size);
        contacts += wanted.overlaps() ? 1 : 0;
    }
    EXPECT_GT(contacts, 50);
}
