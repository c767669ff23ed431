#include "core/base/setupError.hpp"
#include "unit/core/world/pairFound.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

// Needles, grains inside grains, sizes at the ends of what a double holds, outlines at the ends of what is legal.

using namespace chesil;
using test::expectDepth;
using test::findPair;
using test::PairFound;

namespace
{

constexpr double epsilon = tolerances::epsilon;

ConvexPolygon regular(int sides, double radius)
{
    std::vector<Vector2> vertices;
    for (int i = 0; i < sides; ++i)
    {
        vertices.emplace_back(radius * std::cos(2 * M_PI * i / sides), radius * std::sin(2 * M_PI * i / sides));
    }
    return ConvexPolygon(vertices);
}

std::vector<Shape> ofSize(double r)
{
    return {Circle(r), Ellipse(r, r / 2), test::rectangle(r, 2 * r), PolyBezier(test::ellipseSegments(8, r, r / 2))};
}

void expectRight(const Shape& a, const Pose<2>& poseA, const Shape& b, const Pose<2>& poseB, int angles = 2000)
{
    const PairFound found = findPair(a, poseA, b, poseB);
    SCOPED_TRACE("kinds " + std::to_string(a.index()) + ' ' + std::to_string(b.index()));
    const double distance = static_cast<double>(test::preciseDistance(a, poseA, b, poseB, angles));
    expectDepth(found, -distance, found.allowed() + 2 * epsilon * std::abs(distance));
}

CubicBezier cubic(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d)
{
    return CubicBezier({a, b, c, d});
}

std::string refusal(const std::vector<CubicBezier>& segments)
{
    try
    {
        const PolyBezier grain(segments);
    }
    catch (const ValueError& error)
    {
        return error.what();
    }
    return "";
}

} // namespace

TEST(ExtremePairs, aNeedleAndADisk)
{
    const std::vector<Shape> needles{
        Ellipse(1000, 1), Ellipse(1, 1000), test::rectangle(2000, 2), PolyBezier(test::ellipseSegments(12, 1000, 1))};
    test::RandomSource random(741);
    for (const Shape& needle : needles)
    {
        for (const Shape& disk : {Shape(Circle(1)), Shape(Circle(100)), Shape(Ellipse(3, 2))})
        {
            for (int i = 0; i < 6; ++i)
            {
                const Pose<2> poseA{Vector2::Zero(), random.pose(1).rotation};
                Pose<2> poseB = random.pose(1000);
                const PairDistance apart = pairDistance(needle, poseA, disk, poseB);
                poseB.position -= (apart.distance + random.uniform(-0.5, 0.5)) * apart.normal;
                SCOPED_TRACE("pair " + std::to_string(i) + " kinds " + std::to_string(needle.index()) + ' ' + std::to_string(disk.index()));
                const PairFound found = findPair(needle, poseA, disk, poseB);
                const double depth = -static_cast<double>(test::preciseDistance(needle, poseA, disk, poseB, 40000));
                // 1e-12 of the minor axis, or the rounding of positions a thousand of them away.
                expectDepth(found, depth, std::max(1e-12, 8 * epsilon * found.size));
            }
        }
    }
}

TEST(ExtremePairs, at1e15FromEachOther)
{
    for (const Shape& a : ofSize(1))
    {
        for (const Shape& b : ofSize(1))
        {
            for (const double gap : {1e-15, -1e-15, 0.0, 2e-16})
            {
                Pose<2> there{Vector2(0.3, 3), Rotation<2>(0.3)};
                const double apart = static_cast<double>(test::preciseDistance(a, Pose<2>{}, b, there));
                const PairDistance found = pairDistance(a, Pose<2>{}, b, there);
                there.position -= (apart - gap) * found.normal;
                expectRight(a, Pose<2>{}, b, there);
            }
        }
    }
}

TEST(ExtremePairs, aGrainInsideAnother)
{
    test::RandomSource random(742);
    for (const Shape& big : ofSize(1))
    {
        for (const double size : {1e-6, 1e-2, 0.3, 1.0})
        {
            for (const Shape& small : ofSize(size))
            {
                SCOPED_TRACE("size " + std::to_string(size));
                expectRight(big, Pose<2>{}, small, Pose<2>{});
                expectRight(small, Pose<2>{}, big, Pose<2>{});
                for (int i = 0; i < 2; ++i)
                {
                    const Pose<2> inside = random.pose(0.3);
                    expectRight(big, Pose<2>{}, small, inside);
                    expectRight(small, inside, big, Pose<2>{});
                }
            }
        }
        // Identical, at the same place, whatever the turn.
        for (int i = 0; i < 2; ++i)
        {
            const Pose<2> here = random.pose(1);
            expectRight(big, here, big, here);
        }
    }
}

TEST(ExtremePairs, aSizeRatioOfAMillion)
{
    test::RandomSource random(743);
    for (const Shape& big : ofSize(1e6))
    {
        for (const Shape& small : ofSize(1))
        {
            for (int i = 0; i < 6; ++i)
            {
                Pose<2> there{3e6 * random.direction(), random.pose(1).rotation};
                const PairDistance apart = pairDistance(big, Pose<2>{}, small, there);
                there.position -= (apart.distance + random.uniform(-0.2, 0.4)) * apart.normal;
                const PairFound found = findPair(big, Pose<2>{}, small, there);
                const double depth = -static_cast<double>(test::preciseDistance(big, Pose<2>{}, small, there, 8000));
                SCOPED_TRACE("kinds " + std::to_string(big.index()) + ' ' + std::to_string(small.index()));
                expectDepth(found, depth, 4 * epsilon * boundingRadius(big));
            }
        }
    }
}

TEST(ExtremePairs, numbersNearTheEndsOfWhatADoubleHolds)
{
    // A status always; if it says overlapping or separated, all it hands back is finite.
    for (const double scale : {1e-300, 1e-200, 1e-160, 1e-150, 1e-100, 1e-30, 1e30, 1e100, 1e150, 1e160, 1e200, 1e300})
    {
        std::vector<Shape> shapes;
        for (int kind = 0; kind < 4; ++kind)
        {
            try
            {
                shapes.push_back(
                    kind == 0       ? Shape(Circle(scale))
                        : kind == 1 ? Shape(Ellipse(scale, scale / 2))
                        : kind == 2 ? Shape(test::rectangle(scale, 2 * scale))
                                    : Shape(PolyBezier(test::ellipseSegments(8, scale, scale / 2))));
            }
            catch (const ValueError&)
            {
                // Refused at set-up: fine, too.
            }
        }
        for (const Shape& a : shapes)
        {
            for (const Shape& b : shapes)
            {
                for (const Vector2& offset : {Vector2(0, 0), Vector2(1, 0.1), Vector2(0.3, 0.2), Vector2(5, 1), Vector2(1e5, 1)})
                {
                    SCOPED_TRACE("scale " + numberText(scale) + ", kinds " + std::to_string(a.index()) + ' ' + std::to_string(b.index()) + " at " + std::to_string(offset.x()));
                    const Pose<2> there{scale * offset, Rotation<2>(0.3)};
                    const PairFound found = findPair(a, Pose<2>{}, b, there);
                    test::expectFinite(found);
                    if (scale > 1e-101 && scale < 1e101)
                    {
                        // Far from both ends: the answer of the pair at scale 1.
                        const double distance = static_cast<double>(test::preciseDistance(a, Pose<2>{}, b, there, 500));
                        expectDepth(found, -distance, found.allowed() + 4 * epsilon * std::abs(distance));
                    }
                }
            }
        }
    }
    // Grains of ordinary size very far away.
    for (const Shape& a : ofSize(1))
    {
        for (const Shape& b : ofSize(1))
        {
            for (const double far : {1e30, 1e150, 1e160, 1e300})
            {
                const PairFound found = findPair(a, b, {far, far / 3});
                EXPECT_NE(found.status, PairStatus::overlapping) << far;
                EXPECT_NE(found.apart.status, PairStatus::overlapping) << far;
                test::expectFinite(found);
            }
        }
    }
}

TEST(ExtremePairs, outlinesThatAreNoneAreRefused)
{
    const Vector2 o(0, 0);
    const CubicBezier point({o, o, o, o});
    EXPECT_NE(refusal({point, point}).find("four equal control points"), std::string::npos) << refusal({point, point});
    const CubicBezier there = cubic({0, 0}, {1, 0}, {2, 0}, {3, 0});
    const CubicBezier back = cubic({3, 0}, {2, 0}, {1, 0}, {0, 0});
    EXPECT_NE(refusal({there, back}).find("turn back on itself"), std::string::npos) << refusal({there, back});
    // On a line, but running to and fro.
    const CubicBezier fro = cubic({0, 0}, {2, 0}, {1, 0}, {3, 0});
    EXPECT_NE(refusal({fro, back}), "");
    // A slope whose rounding is not the line's.
    const CubicBezier slanted = cubic({0, 0}, {0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9});
    const CubicBezier returning = cubic({0.3, 0.9}, {0.2, 0.6}, {0.1, 0.3}, {0, 0});
    EXPECT_NE(refusal({slanted, returning}), "");
    EXPECT_NE(refusal({there}), "");
    EXPECT_NE(refusal({}), "");
    // A loop within a segment, clockwise, open.
    EXPECT_NE(refusal({cubic({0, 0}, {3, 1}, {-2, 1}, {1, 0}), CubicBezier::straight({1, 0}, {0, 0})}), "");
    std::vector<Vector2> clockwise = test::rectangleVertices(1, 1);
    std::reverse(clockwise.begin(), clockwise.end());
    EXPECT_NE(refusal(test::polygonSegments(clockwise)), "");
    std::vector<CubicBezier> open = test::polygonSegments(test::rectangleVertices(1, 1));
    open.pop_back();
    EXPECT_NE(refusal(open).find("away from the start"), std::string::npos);
}

TEST(ExtremePairs, segmentsThatAreNearlyACusp)
{
    // The middle control points reach ever nearer to the crossing of the end tangents, where the curvature peaks;
    // at share 1 they meet there.
    for (const double rest : {0.1, 1e-2, 1e-4, 1e-8, 1e-12, 0.0})
    {
        const double share = 1 - rest;
        std::vector<CubicBezier> segments;
        const std::vector<Vector2> ends{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        const std::vector<Vector2> corners{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
        for (std::size_t i = 0; i < 4; ++i)
        {
            const Vector2& start = ends[i];
            const Vector2& end = ends[(i + 1) % 4];
            segments.push_back(CubicBezier(
                {start, start + share * (corners[i] - start), end + share * (corners[i] - end), end}));
        }
        ASSERT_EQ(refusal(segments), "") << rest;
        const PolyBezier grain(segments);
        test::RandomSource random(744);
        for (const Shape& other : {Shape(Circle(0.5)), Shape(Ellipse(1, 0.2)), Shape(test::rectangle(1, 1)), Shape(grain)})
        {
            for (int i = 0; i < 10; ++i)
            {
                const Pose<2> here{Vector2::Zero(), random.pose(1).rotation};
                Pose<2> there{2 * random.direction(), random.pose(1).rotation};
                const PairDistance apart = pairDistance(grain, here, other, there);
                there.position -= (apart.distance + random.logUniform(1e-9, 0.1)) * apart.normal;
                SCOPED_TRACE("rest " + numberText(rest) + ", pair " + std::to_string(i) + ", other " + std::to_string(other.index()));
                const PairFound found = findPair(grain, here, other, there);
                expectDepth(found, -static_cast<double>(test::preciseDistance(grain, here, other, there)), 1e-12);
            }
        }
    }
    // A cusp: the curve stops and turns within the segment. Its control polygon is not convex.
    EXPECT_NE(refusal({cubic({0, 0}, {2, 1}, {0, 1}, {2, 0}), CubicBezier::straight({2, 0}, {0, 0})}), "");
}

TEST(ExtremePairs, polygonsOfManySides)
{
    test::RandomSource random(745);
    const Shape thousand = regular(1000, 1);
    const Shape twoHundred = regular(200, 1);
    const std::vector<Shape> others{
        Circle(0.7), Ellipse(1, 0.4), test::rectangle(1, 1), PolyBezier(test::ellipseSegments(8, 1, 0.6)), twoHundred};
    for (const Shape& polygon : {twoHundred, thousand})
    {
        for (const Shape& other : others)
        {
            const int pairs = &polygon == &thousand ? 2 : 4;
            for (int i = 0; i < pairs; ++i)
            {
                Pose<2> there{2 * random.direction(), random.pose(1).rotation};
                const PairDistance apart = pairDistance(polygon, Pose<2>{}, other, there);
                there.position -= (apart.distance + random.uniform(-1e-3, 1e-2)) * apart.normal;
                expectRight(polygon, Pose<2>{}, other, there, 4000);
            }
            expectRight(polygon, Pose<2>{}, other, {Vector2(0.1, 0.2), Rotation<2>(0.3)}, 4000);
        }
    }
}
