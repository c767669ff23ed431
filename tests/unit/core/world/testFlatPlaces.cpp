#include "core/world/flatContact.hpp"

#include "core/narrowphase/flatPlaces.hpp"
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

using Places = std::array<FlatGeometry, 2>;

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

/// Of springs of stiffness 1 between A at the origin and B.
double energy(const Flat& found)
{
    double sum = 0;
    for (const FlatGeometry& place : found.places)
    {
        sum += found.two && place.depth > 0 ? place.depth * place.depth / 2 : 0;
    }
    return sum;
}

/// Force and torque on B of these springs, B's centroid at `position`, and the sum of the forces' sizes.
struct Load
{
    Vector2 force = Vector2::Zero();
    double torque = 0;
    double size = 0;
};

Load loadOn(const Flat& found, const Vector2& position)
{
    Load load;
    for (const FlatGeometry& place : found.places)
    {
        const double pressing = std::max(0.0, place.depth);
        const Vector2 push = pressing * (place.share.weight * place.normal + place.share.depthPerWay);
        load.force += push;
        load.torque += cross(place.point - position, push) + pressing * place.share.depthPerTurn;
        load.size += push.norm();
    }
    return load;
}

/// How far force and torque on B are from minus the gradient of the energy, by central differences, relative.
double offGradient(const Shape& a, const Shape& b, const Vector2& position, double angle)
{
    constexpr double step = 1e-6;
    const auto at = [&](const Vector2& move, double turn)
    { return energy(flat(a, Pose<2>{}, b, {position + step * move, Rotation<2>(angle + step * turn)})); };
    const auto slope = [&](const Vector2& move, double turn) { return (at(move, turn) - at(-move, -turn)) / (2 * step); };
    const Load load = loadOn(flat(a, Pose<2>{}, b, {position, Rotation<2>(angle)}), position);
    return std::max(
               {std::abs(load.force.x() + slope({1, 0}, 0)),
                std::abs(load.force.y() + slope({0, 1}, 0)),
                std::abs(load.torque + slope({0, 0}, 1))})
        / load.size;
}

Shape polygon(test::RandomSource& random)
{
    return test::randomPolygon(random.integer(4, 7), 1, random);
}

/// A polygon, or a polybezier with straight sides, most of them.
Shape withStraightSides(test::RandomSource& random)
{
    return random.integer(0, 1) == 0 ? polygon(random) : test::grainOfKind(3, random);
}

/// Two grains whose overlap is `depth`, B turned at random.
struct RandomPair
{
    RandomPair(Shape (*grain)(test::RandomSource&), double depth, test::RandomSource& random)
        : a(grain(random)), b(grain(random)), angle(random.uniform(0, 2 * M_PI))
    {
        const double direction = random.uniform(0, 2 * M_PI);
        const Vector2 away(std::cos(direction), std::sin(direction));
        double deep = 0;
        double apart = 4;
        for (int i = 0; i < 50; ++i)
        {
            const double middle = (deep + apart) / 2;
            const PairFound found = findPair(a, Pose<2>{}, b, {middle * away, Rotation<2>(angle)});
            (found.status == PairStatus::overlapping && found.contact.depth > depth ? deep : apart) = middle;
        }
        position = deep * away;
    }

    Shape a;
    Shape b;
    Vector2 position;
    double angle;
};

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
                        const double ratio = (right - left) / std::max(atRight, atLeft);
                        const double weight = FlatWeight::of(std::sin(angle), ratio).value;
                        const double ofRight = atRight < atLeft ? weight : 1;
                        const double ofLeft = atLeft < atRight ? weight : 1;
                        EXPECT_NEAR(std::max(0.0, found.places[0].depth), std::max(0.0, atRight) * ofRight, 2 * angle * angle + 1e-14);
                        EXPECT_NEAR(std::max(0.0, found.places[1].depth), std::max(0.0, atLeft) * ofLeft, 2 * angle * angle + 1e-14);
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
    for (const Shape& a : tiles())
    {
        for (const Shape& b : tiles())
        {
            for (const double aside : {0.0, 0.3, -0.7})
            {
                for (const double angle : {0.0, 1e-12, -1e-9, 1e-6, 1e-4, -1e-3, 3e-3, 0.03, 0.05, -0.1})
                {
                    EXPECT_LT(offGradient(a, b, Vector2(aside, 2 - 1e-2), angle), 1e-6) << "angle " << angle << ", aside " << aside;
                }
            }
        }
    }
}

TEST(FlatPlaces, springsOfRandomPolygonsConserveEnergyToo)
{
    constexpr std::uint64_t seed = 20261123;
    test::RandomSource random(seed);
    int tilted = 0;
    int shortened = 0;
    std::vector<double> off;
    for (int i = 0; i < 20000; ++i)
    {
        const RandomPair pair(polygon, 0.05 * random.uniform(0.1, 1), random);
        const Flat found = flat(pair.a, Pose<2>{}, pair.b, {pair.position, Rotation<2>(pair.angle)});
        ASSERT_TRUE(found.two);
        for (const FlatGeometry& place : found.places)
        {
            tilted += place.depth > 0 && place.share.depthPerTurn != 0;
            shortened += place.depth > 0 && place.share.depthPerWay.norm() > 0;
        }
        off.push_back(offGradient(pair.a, pair.b, pair.position, pair.angle));
    }
    // Where another corner or side takes over within the differences' step, there is no gradient
    std::sort(off.begin(), off.end());
    EXPECT_LT(off[off.size() - 20], 1e-4) << "seed " << seed;
    EXPECT_GT(tilted, 100);
    EXPECT_GT(shortened, 100);
}

TEST(FlatPlaces, theEnergyOfRandomGrainsIsContinuous)
{
    constexpr std::uint64_t seed = 20261124;
    constexpr int steps = 500;
    constexpr double way = 0.04;
    test::RandomSource random(seed);
    for (int i = 0; i < 4000; ++i)
    {
        const RandomPair pair(withStraightSides, 0.02 * random.uniform(0.2, 1.5), random);
        const double direction = random.uniform(0, 2 * M_PI);
        const Vector2 move = way / steps * Vector2(std::cos(direction), std::sin(direction));
        const double turn = way / steps * random.uniform(-1, 1);
        Flat before;
        for (int step = 0; step < steps; ++step)
        {
            const Pose<2> pose{pair.position + step * move, Rotation<2>(pair.angle + step * turn)};
            const Flat now = flat(pair.a, Pose<2>{}, pair.b, pose);
            const double most = std::sqrt(2 * std::max(energy(before), energy(now)));
            // Two places, each moving by at most the way of a corner 1.5 m from the centroid; the weights, some times that
            const double change = 6 * (move.norm() + 1.5 * std::abs(turn)) * most;
            if (before.two && now.two)
            {
                ASSERT_LE(std::abs(energy(now) - energy(before)), change) << "seed " << seed << ", pair " << i << ", step " << step;
            }
            before = now;
        }
    }
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
                const double overlap = -wall.distance(nearest);
                EXPECT_NEAR(places[k].depth, places[k].share.weight * overlap, 1e-15);
                EXPECT_LT((places[k].point - nearest - overlap / 2 * wall.normal).norm(), 1e-15);
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
