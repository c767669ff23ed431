#pragma once

#include "core/base/tolerances.hpp"
#include "core/world/pairContact.hpp"
#include "core/world/pairDistance.hpp"
#include "unit/core/world/precisePair.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

/// What pairContact and pairDistance say of a pair, and what they promise.
namespace chesil::test
{

/// A random grain: a disk, an ellipse, a polygon or a polybezier for kind 0 to 3; about 1 m wide.
inline Shape grainOfKind(int kind, RandomSource& random)
{
    RandomGrainOptions options;
    options.straight = random.integer(0, 2);
    options.nearlyStraight = random.integer(0, 1);
    const double a = random.uniform(0.5, 1.5);
    return kind == 0 ? Shape(Circle(a))
        : kind == 1  ? Shape(Ellipse(a, random.uniform(0.3, 1.5)))
        : kind == 2  ? Shape(randomPolygon(random.integer(3, 9), 1, random))
                     : Shape(randomPolyBezier(options, random));
}

struct PairFound
{
    PairStatus status;
    ContactGeometry<2> contact;
    SearchStart start;
    QueryCost cost;
    PairDistance apart;
    /// Sum of both bounding radii, and the smaller of them [m].
    double size;
    double smaller;

    bool overlaps() const { return status == PairStatus::overlapping; }

    /// How far a depth or distance may be off [m].
    double allowed() const { return std::max(1e-14 * smaller, 8 * tolerances::epsilon * size); }
};

inline PairFound findPair(
    const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB, const SearchStart& start = {})
{
    PairFound found{};
    found.contact = {0, Vector2::Zero(), Vector2::Zero()};
    found.start = start;
    found.status = pairContact(a, poseA, b, poseB, found.start, found.contact, found.cost);
    found.apart = pairDistance(a, poseA, b, poseB, start.direction);
    found.size = boundingRadius(a) + boundingRadius(b);
    found.smaller = std::min(boundingRadius(a), boundingRadius(b));
    return found;
}

/// A at the origin, turned by nothing.
inline PairFound findPair(const Shape& a, const Shape& b, const Vector2& positionB, double angleB = 0)
{
    return findPair(a, Pose<2>{}, b, Pose<2>{positionB, Rotation<2>(angleB)});
}

inline void expectFinite(const PairFound& found)
{
    if (found.overlaps())
    {
        EXPECT_TRUE(std::isfinite(found.contact.depth));
        EXPECT_GT(found.contact.depth, 0);
        EXPECT_NEAR(found.contact.normal.norm(), 1, 8 * tolerances::epsilon);
        EXPECT_TRUE(found.contact.point.allFinite());
    }
    if (found.apart.status == PairStatus::overlapping || found.apart.status == PairStatus::separated)
    {
        EXPECT_TRUE(std::isfinite(found.apart.distance));
        EXPECT_NEAR(found.apart.normal.norm(), 1, 8 * tolerances::epsilon);
        EXPECT_TRUE(found.apart.onA.allFinite());
        EXPECT_TRUE(found.apart.onB.allFinite());
    }
}

/// Both queries give this depth (negative: a distance) within `allowed`, and agree with each other.
inline void expectDepth(const PairFound& found, double depth, double allowed)
{
    expectFinite(found);
    if (std::abs(depth) > allowed)
    {
        EXPECT_EQ(found.status, depth > 0 ? PairStatus::overlapping : PairStatus::separated) << depth;
        EXPECT_EQ(found.apart.status, depth > 0 ? PairStatus::overlapping : PairStatus::separated) << depth;
    }
    if (found.overlaps())
    {
        EXPECT_NEAR(found.contact.depth, depth, allowed);
    }
    EXPECT_NEAR(-found.apart.distance, depth, allowed);
}

inline void expectDepth(const PairFound& found, double depth) { expectDepth(found, depth, found.allowed()); }

inline void expectContact(const PairFound& found, double depth, const Vector2& normal, double normalError)
{
    expectDepth(found, depth);
    ASSERT_TRUE(found.overlaps());
    EXPECT_LT((found.contact.normal - normal).norm(), normalError) << found.contact.normal.transpose();
    EXPECT_LT((found.apart.normal - normal).norm(), normalError) << found.apart.normal.transpose();
}

/// onB - onA is the distance along the normal, and both lie on their outlines.
inline void expectWitnesses(
    const PairFound& found, const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB, int angles = 2000)
{
    const PairDistance& apart = found.apart;
    const double far = std::max(poseA.position.norm(), poseB.position.norm());
    const double rounding = found.allowed() + 4 * tolerances::epsilon * far;
    EXPECT_LE(((apart.onB - apart.onA) - apart.distance * apart.normal).norm(), rounding);
    EXPECT_NEAR(static_cast<double>(preciseDistance(a, poseA, apart.onA, angles)), 0, rounding);
    EXPECT_NEAR(static_cast<double>(preciseDistance(b, poseB, apart.onB, angles)), 0, rounding);
    if (found.overlaps())
    {
        const Vector2 middle = (apart.onA + apart.onB) / 2;
        EXPECT_NEAR((found.contact.point - middle).dot(apart.normal), 0, rounding);
    }
}

} // namespace chesil::test
