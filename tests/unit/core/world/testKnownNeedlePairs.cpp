#include "core/base/setupError.hpp"
#include "unit/core/world/pairFound.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

// Needles in positions whose contact is known by formula, through pairContact and pairDistance.

using namespace chesil;
using test::expectDepth;
using test::findPair;
using test::PairFound;

namespace
{

/// The same outline as a polygon and as a polybezier.
std::vector<Shape> bothKinds(const std::vector<Vector2>& vertices)
{
    return {ConvexPolygon(vertices), PolyBezier(test::polygonSegments(vertices))};
}

/// A needle without width: what the support contract takes, though no grain is one.
struct Segment
{
    Vector2 half;

    Vector2 support(const Vector2& direction) const { return direction.dot(half) >= 0 ? half : Vector2(-half); }
    double boundingRadius() const { return half.norm(); }
};

Penetration<2> ofSegments(const Vector2& halfA, const Vector2& halfB, const Vector2& offset)
{
    const Segment a{halfA};
    const Segment b{halfB};
    const Pose<2> poseA;
    const Pose<2> poseB{offset, {}};
    return penetrationByExpansion<2>(MinkowskiDifference<2, Segment, Segment>(a, poseA, b, poseB), Vector2(1, 0));
}

} // namespace

TEST(KnownNeedlePairs, crossedNeedles)
{
    const Penetration<2> crossed = ofSegments({1, 0}, {0, 1}, {0, 0});
    EXPECT_EQ(crossed.status, PairStatus::overlapping);
    EXPECT_NEAR(crossed.depth, 1, 1e-14);
    for (const double width : {1e-3, 1e-6, 1e-9, 1e-12})
    {
        for (const Shape& a : bothKinds(test::rectangleVertices(2, width)))
        {
            for (const Shape& b : bothKinds(test::rectangleVertices(2, width)))
            {
                SCOPED_TRACE(width);
                expectDepth(findPair(a, b, {0, 0}, M_PI / 2), 1 + width / 2);
            }
        }
    }
}

TEST(KnownNeedlePairs, collinearNeedles)
{
    const Penetration<2> collinear = ofSegments({1, 0}, {1, 0}, {0.5, 0});
    EXPECT_NE(collinear.status, PairStatus::undecided);
    EXPECT_NE(collinear.status, PairStatus::notFinite);
    EXPECT_NEAR(collinear.depth, 0, 1e-14);
    EXPECT_NEAR(std::abs(unit(collinear.normal).y()), 1, 1e-14);
    for (const double width : {1e-3, 1e-6, 1e-9, 1e-12})
    {
        for (const Shape& a : bothKinds(test::rectangleVertices(2, width)))
        {
            for (const Shape& b : bothKinds(test::rectangleVertices(2, width)))
            {
                SCOPED_TRACE(width);
                const PairFound found = findPair(a, b, {0.5, 0});
                ASSERT_TRUE(found.overlaps());
                expectDepth(found, width);
                EXPECT_NEAR(std::abs(found.contact.normal.y()), 1, 1e-14);
            }
        }
    }
}

TEST(KnownNeedlePairs, needlesWithoutWidthAreNoGrains)
{
    EXPECT_THROW(ConvexPolygon({{-1, 0}, {1, 0}}), ValueError);
    EXPECT_THROW(ConvexPolygon({{-1, 0}, {1, 0}, {1, 0}, {-1, 0}}), ValueError);
}
