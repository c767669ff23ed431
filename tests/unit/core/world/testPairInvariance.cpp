#include "core/base/setupError.hpp"
#include "core/world/wallContact.hpp"
#include "unit/core/world/pairFound.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

// What a pair's contact may not depend on: the unit of length, the frame, which grain comes first, where the search
// starts. And numbers that are none.

using namespace chesil;
using test::expectDepth;
using test::findPair;
using test::PairFound;

namespace
{

constexpr double epsilon = tolerances::epsilon;

Shape scaled(const Shape& shape, double scale)
{
    if (const auto* circle = std::get_if<Circle>(&shape))
    {
        return Circle(scale * circle->radius());
    }
    if (const auto* ellipse = std::get_if<Ellipse>(&shape))
    {
        return Ellipse(scale * ellipse->a(), scale * ellipse->b());
    }
    if (const auto* polygon = std::get_if<ConvexPolygon>(&shape))
    {
        std::vector<Vector2> vertices;
        for (const Vector2& vertex : polygon->vertices())
        {
            vertices.push_back(scale * vertex);
        }
        return ConvexPolygon(vertices);
    }
    std::vector<CubicBezier> segments;
    for (const CubicBezier& segment : std::get<PolyBezier>(shape).segments())
    {
        segments.push_back(segment.transformed(Vector2::Zero(), 1, 0, scale));
    }
    return PolyBezier(segments);
}

struct Pair
{
    Shape a;
    Pose<2> poseA;
    Shape b;
    Pose<2> poseB;
};

/// All kinds, overlapping or not.
std::vector<Pair> somePairs(std::uint64_t seed, int count = 400)
{
    test::RandomSource random(seed);
    std::vector<Pair> pairs;
    for (int i = 0; i < count; ++i)
    {
        const Shape a = test::grainOfKind(i % 4, random);
        const Shape b = test::grainOfKind(i / 4 % 4, random);
        const Pose<2> poseA = random.pose(1);
        Pose<2> poseB = random.pose(1.5);
        if (i % 2 == 0)
        {
            const PairDistance apart = pairDistance(a, poseA, b, poseB);
            poseB.position -= (apart.distance + random.logUniform(1e-9, 1e-2)) * apart.normal;
        }
        pairs.push_back({a, poseA, b, poseB});
    }
    return pairs;
}

std::string nameOf(const Pair& pair, std::size_t i)
{
    return "pair " + std::to_string(i) + ", kinds " + std::to_string(pair.a.index()) + ' ' + std::to_string(pair.b.index());
}

} // namespace

TEST(PairInvariance, scaledByPowersOfTwoTheSameBits)
{
    const std::vector<Pair> pairs = somePairs(721);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        const Pair& pair = pairs[i];
        SCOPED_TRACE(nameOf(pair, i));
        const PairFound one = findPair(pair.a, pair.poseA, pair.b, pair.poseB);
        for (const double scale : {std::ldexp(1, 20), std::ldexp(1, -20), std::ldexp(1, -60), 2.0, 0.5})
        {
            const Pose<2> poseA{scale * pair.poseA.position, pair.poseA.rotation};
            const Pose<2> poseB{scale * pair.poseB.position, pair.poseB.rotation};
            const PairFound other = findPair(scaled(pair.a, scale), poseA, scaled(pair.b, scale), poseB);
            ASSERT_EQ(one.status, other.status);
            EXPECT_EQ(one.contact.depth * scale, other.contact.depth);
            EXPECT_EQ(one.contact.normal, other.contact.normal);
            EXPECT_EQ(one.contact.point * scale, other.contact.point);
            EXPECT_EQ(one.start.direction, other.start.direction);
            EXPECT_EQ(one.cost.supportCalls, other.cost.supportCalls);
            EXPECT_EQ(one.apart.distance * scale, other.apart.distance);
            EXPECT_EQ(one.apart.onA * scale, other.apart.onA);
        }
    }
}

TEST(PairInvariance, scaledByAMillion)
{
    const std::vector<Pair> pairs = somePairs(722);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        const Pair& pair = pairs[i];
        SCOPED_TRACE(nameOf(pair, i));
        const PairFound one = findPair(pair.a, pair.poseA, pair.b, pair.poseB);
        for (const double scale : {1e6, 1e-6})
        {
            const Pose<2> poseA{scale * pair.poseA.position, pair.poseA.rotation};
            const Pose<2> poseB{scale * pair.poseB.position, pair.poseB.rotation};
            const PairFound other = findPair(scaled(pair.a, scale), poseA, scaled(pair.b, scale), poseB);
            ASSERT_EQ(one.status, other.status);
            EXPECT_NEAR(one.contact.depth, other.contact.depth / scale, 1e-13);
            EXPECT_NEAR(one.apart.distance, other.apart.distance / scale, 1e-13);
        }
    }
}

TEST(PairInvariance, movedByAMillionSizes)
{
    const std::vector<Pair> pairs = somePairs(723);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        const Pair& pair = pairs[i];
        SCOPED_TRACE(nameOf(pair, i));
        for (const Vector2& away : {Vector2(1e6, -1e6), Vector2(0, 1e6), Vector2(1e12, 1e12)})
        {
            // The value of the rounded positions: that of A at the origin and B at their exact difference.
            const Pose<2> poseA{pair.poseA.position + away, pair.poseA.rotation};
            const Pose<2> poseB{pair.poseB.position + away, pair.poseB.rotation};
            const Pose<2> nearA{Vector2::Zero(), pair.poseA.rotation};
            const Pose<2> nearB{poseB.position - poseA.position, pair.poseB.rotation};
            const PairFound far = findPair(pair.a, poseA, pair.b, poseB);
            const PairFound near = findPair(pair.a, nearA, pair.b, nearB);
            ASSERT_EQ(far.status, near.status);
            EXPECT_EQ(far.contact.depth, near.contact.depth);
            EXPECT_EQ(far.contact.normal, near.contact.normal);
            EXPECT_EQ(far.apart.distance, near.apart.distance);
            EXPECT_EQ(far.apart.normal, near.apart.normal);
            if (far.overlaps())
            {
                EXPECT_LT((near.contact.point + poseA.position - far.contact.point).norm(), epsilon * away.norm());
            }
        }
    }
}

TEST(PairInvariance, swapped)
{
    const std::vector<Pair> pairs = somePairs(724);
    double worstNormal = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        const Pair& pair = pairs[i];
        SCOPED_TRACE(nameOf(pair, i));
        const PairFound one = findPair(pair.a, pair.poseA, pair.b, pair.poseB);
        const PairFound other = findPair(pair.b, pair.poseB, pair.a, pair.poseA);
        ASSERT_EQ(one.status, other.status);
        EXPECT_NEAR(one.contact.depth, other.contact.depth, one.allowed());
        EXPECT_NEAR(one.apart.distance, other.apart.distance, one.allowed());
        if (one.overlaps())
        {
            const double turned = (one.contact.normal + other.contact.normal).norm();
            worstNormal = std::max(worstNormal, turned);
            EXPECT_LT(turned, 1e-8);
        }
    }
    RecordProperty("worstNormal", std::to_string(worstNormal * 1e12) + "e-12");
}

TEST(PairInvariance, turnedTogether)
{
    const std::vector<Pair> pairs = somePairs(725);
    test::RandomSource random(726);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        const Pair& pair = pairs[i];
        SCOPED_TRACE(nameOf(pair, i));
        const Rotation<2> turn(random.uniform(-M_PI, M_PI));
        const auto turned = [&](const Pose<2>& pose)
        { return Pose<2>{turn.apply(pose.position), Rotation<2>(pose.rotation.angle() + turn.angle())}; };
        const PairFound one = findPair(pair.a, pair.poseA, pair.b, pair.poseB);
        const PairFound other = findPair(pair.a, turned(pair.poseA), pair.b, turned(pair.poseB));
        ASSERT_EQ(one.status, other.status);
        EXPECT_NEAR(one.contact.depth, other.contact.depth, 1e-14 * one.size);
        EXPECT_NEAR(one.apart.distance, other.apart.distance, 1e-14 * one.size);
        if (one.overlaps())
        {
            EXPECT_LT((turn.apply(one.contact.normal) - other.contact.normal).norm(), 1e-8);
        }
    }
}

TEST(PairInvariance, notANumberHasAStatus)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    test::RandomSource random(728);
    for (int kindA = 0; kindA < 4; ++kindA)
    {
        for (int kindB = 0; kindB < 4; ++kindB)
        {
            const Shape a = test::grainOfKind(kindA, random);
            const Shape b = test::grainOfKind(kindB, random);
            SCOPED_TRACE(std::to_string(kindA) + ' ' + std::to_string(kindB));
            const bool turnsMatter = kindA > 0 || kindB > 0;
            for (const double bad : {nan, infinite, -infinite})
            {
                for (const Vector2& position : {Vector2(bad, 0.1), Vector2(0.1, bad), Vector2(bad, bad)})
                {
                    const Pose<2> broken{position, {}};
                    EXPECT_EQ(findPair(a, Pose<2>{}, b, broken).status, PairStatus::notFinite);
                    EXPECT_EQ(findPair(a, broken, b, Pose<2>{}).status, PairStatus::notFinite);
                    EXPECT_EQ(findPair(a, broken, b, broken).status, PairStatus::notFinite);
                    EXPECT_EQ(findPair(a, Pose<2>{}, b, broken).apart.status, PairStatus::notFinite);
                    EXPECT_EQ(findPair(a, broken, b, Pose<2>{}).apart.status, PairStatus::notFinite);
                }
                const Pose<2> turned{Vector2(0.1, 0), Rotation<2>(bad)};
                if (turnsMatter && kindB > 0)
                {
                    EXPECT_EQ(findPair(a, Pose<2>{}, b, turned).status, PairStatus::notFinite);
                    EXPECT_EQ(findPair(a, Pose<2>{}, b, turned).apart.status, PairStatus::notFinite);
                }
                // A direction that is none, carried from a broken step: the pair's answer, or a status.
                for (const Vector2& direction : {Vector2(bad, 0), Vector2(bad, bad)})
                {
                    const PairFound found = findPair(a, Pose<2>{}, b, {Vector2(0.1, 0), {}}, SearchStart{direction});
                    EXPECT_TRUE(found.overlaps() || found.status == PairStatus::notFinite) << int(found.status);
                    test::expectFinite(found);
                }
            }
        }
    }
}

TEST(PairInvariance, zeroesHaveAnAnswer)
{
    test::RandomSource random(729);
    for (int kindA = 0; kindA < 4; ++kindA)
    {
        for (int kindB = 0; kindB < 4; ++kindB)
        {
            const Shape a = test::grainOfKind(kindA, random);
            const Shape b = test::grainOfKind(kindB, random);
            SCOPED_TRACE(std::to_string(kindA) + ' ' + std::to_string(kindB));
            const PairFound found = findPair(a, b, {0, 0});
            expectDepth(found, -static_cast<double>(test::preciseDistance(a, Pose<2>{}, b, Pose<2>{})));
            const PairFound minus = findPair(a, b, {-0.0, -0.0});
            EXPECT_EQ(minus.contact.depth, found.contact.depth);
        }
    }
    EXPECT_THROW(Circle(0), ValueError);
    EXPECT_THROW(Ellipse(0, 1), ValueError);
    EXPECT_THROW(Ellipse(1, 0), ValueError);
    EXPECT_THROW(ConvexPolygon({{0, 0}, {0, 0}, {0, 0}}), ValueError);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Circle{nan}, ValueError);
    EXPECT_THROW(Ellipse(1, nan), ValueError);
    EXPECT_THROW(ConvexPolygon({{0, 0}, {1, nan}, {0, 1}}), ValueError);
    EXPECT_THROW(PolyBezier(test::polygonSegments({{0, 0}, {1, 0}, {nan, 1}})), ValueError);
}
