#include "core/shapes/polyBezier.hpp"

#include "core/base/setupError.hpp"
#include "unit/knownShapes.hpp"
#include "unit/preciseCurve.hpp"
#include "unit/randomGrain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;
using testing::HasSubstr;

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::string refusal(const std::vector<CubicBezier>& segments)
{
    try
    {
        PolyBezier grain(segments);
    }
    catch (const ValueError& error)
    {
        EXPECT_NE(error.expected(), "");
        return error.found();
    }
    ADD_FAILURE() << "not refused";
    return "";
}

/// With one control point replaced.
std::vector<CubicBezier> changed(std::vector<CubicBezier> segments, std::size_t segment, std::size_t point,
                                 const Vector2& to)
{
    auto points = segments[segment].controlPoints();
    points[point] = to;
    segments[segment] = CubicBezier(points);
    return segments;
}

std::vector<CubicBezier> reversed(const std::vector<CubicBezier>& segments)
{
    std::vector<CubicBezier> result;
    for (auto segment = segments.rbegin(); segment != segments.rend(); ++segment)
    {
        const auto& p = segment->controlPoints();
        result.push_back(CubicBezier({p[3], p[2], p[1], p[0]}));
    }
    return result;
}

} // namespace

TEST(PolyBezier, refusesAnOpenOutline)
{
    const auto circle = test::ellipseSegments(8, 1, 1);
    EXPECT_THAT(refusal(changed(circle, 3, 3, circle[3].end() + Vector2(1e-15, 0))),
                HasSubstr("segment 3 ends"));
    EXPECT_THAT(refusal({circle[0], circle[1]}), HasSubstr("m away"));
    EXPECT_THAT(refusal({}), HasSubstr("0 segments"));
    EXPECT_THAT(refusal({circle[0]}), HasSubstr("1 segments"));
}

TEST(PolyBezier, refusesClockwise)
{
    EXPECT_THAT(refusal(reversed(test::ellipseSegments(8, 1, 1))), HasSubstr("inward turn"));
}

TEST(PolyBezier, refusesADent)
{
    const auto circle = test::ellipseSegments(8, 1, 1);
    EXPECT_THAT(refusal(changed(circle, 0, 1, Vector2(0.8, 0.2))), HasSubstr("inward turn"));
}

TEST(PolyBezier, refusesCrossingItself)
{
    // Twice around: no dent anywhere.
    const auto circle = test::ellipseSegments(4, 1, 1);
    auto twice = test::ellipseSegments(4, 2, 2);
    twice.insert(twice.begin(), circle.begin(), circle.end());
    EXPECT_THAT(refusal(test::joined(twice)), testing::Not(""));
    std::vector<CubicBezier> doubled = circle;
    doubled.insert(doubled.end(), circle.begin(), circle.end());
    EXPECT_THAT(refusal(doubled), HasSubstr("2 full turns"));
    // Control edges that cross (a loop) within one segment.
    EXPECT_THAT(refusal(changed(changed(circle, 0, 1, {1, 3}), 0, 2, {3, 1})), HasSubstr("inward turn"));
}

TEST(PolyBezier, refusesWhatIsNotFinite)
{
    const auto circle = test::ellipseSegments(8, 1, 1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refusal(changed(circle, 2, 1, Vector2(nan, 0))), HasSubstr("not a number"));
    EXPECT_THAT(refusal(changed(circle, 2, 2, Vector2(0, INFINITY))), HasSubstr("not a number"));
    EXPECT_NE(refusal(changed(circle, 2, 3, Vector2(nan, 0))), "");
}

TEST(PolyBezier, refusesASegmentWithoutLength)
{
    auto circle = test::ellipseSegments(4, 1, 1);
    const Vector2 joint = circle[1].end();
    circle.insert(circle.begin() + 2, CubicBezier({joint, joint, joint, joint}));
    EXPECT_THAT(refusal(circle), HasSubstr("segment 2 with four equal control points"));
}

TEST(PolyBezier, refusesASegmentThatTurnsByMoreThanHalfATurn)
{
    // 240 degrees in one segment: its support point is beyond the closed form (two roots in (0, 1)).
    const Vector2 a(0, 0);
    const Vector2 b(1, 0);
    const Vector2 c(0.9, 0.6);
    const Vector2 d(0.3, 0.2);
    EXPECT_THAT(refusal({CubicBezier({a, b, c, d}), CubicBezier::straight(d, a)}),
                HasSubstr("segment 0 turns by"));
}

TEST(PolyBezier, directionOfAJointGivesTheJoint)
{
    const auto segments = test::ellipseSegments(12, 2, 1);
    const PolyBezier grain(segments);
    for (const CubicBezier& segment : grain.segments())
    {
        const Vector2 normal = -perpendicular(segment.startTangent());
        EXPECT_LT((grain.support(normal) - segment.start()).norm(), 4 * epsilon);
    }
    EXPECT_LT(grain.largestJointAngle(), 1e-12);
}

TEST(PolyBezier, aConeOfDirectionsGivesTheCorner)
{
    const PolyBezier tile(test::polygonSegments(test::rectangleVertices(2, 1)));
    EXPECT_NEAR(tile.largestJointAngle(), M_PI / 2, 1e-15);
    for (const double angle : {0.001, 0.7, 1.57})
    {
        EXPECT_LT((tile.support({std::cos(angle), std::sin(angle)}) - Vector2(1, 0.5)).norm(), 4 * epsilon);
    }
}

TEST(PolyBezier, repeatedControlPointsAreFinite)
{
    // A rounded triangle whose control points coincide at starts, at ends, and in the middle of its segments.
    const Vector2 a(0, 0);
    const Vector2 b(2, 0);
    const Vector2 c(1, 2);
    const PolyBezier grain({CubicBezier({a, a, b, b}), CubicBezier({b, b, b, c}), CubicBezier({c, c, c, a})});
    for (int i = 0; i < 3600; ++i)
    {
        const double angle = 2 * M_PI * i / 3600;
        const Vector2 direction(std::cos(angle), std::sin(angle));
        const Vector2 point = grain.support(direction);
        ASSERT_TRUE(point.allFinite()) << i;
        const Vector2 world = point + grain.givenCentroid();
        EXPECT_NEAR(direction.dot(world), std::max({direction.dot(a), direction.dot(b), direction.dot(c)}),
                    8 * epsilon);
    }
}

TEST(PolyBezier, collinearJointsAtTheSeamOfTheSearchKeepTheirOrder)
{
    // Three joints on the right side, where the search key jumps from 4 to 0, with edges that rounding turns
    // a little inward or outward.
    for (const double nudge : {0.0, 2e-16, -2e-16, 2e-10, -2e-10})
    {
        std::vector<Vector2> vertices{{1, -1}, {1 + nudge, 0}, {1, 1},   {0, 1.5},
                                      {-1, 1}, {-1, -1},       {0, -1.5}};
        for (std::size_t start = 0; start < vertices.size(); ++start)
        {
            const PolyBezier grain(test::polygonSegments(vertices));
            const ConvexPolygon polygon(vertices);
            for (int i = 0; i < 360; ++i)
            {
                const Vector2 direction(std::cos(i * M_PI / 180), std::sin(i * M_PI / 180));
                double furthest = -10;
                for (const Vector2& vertex : vertices)
                {
                    furthest = std::max(furthest, vertex.dot(direction));
                }
                const double slack = 8 * epsilon + std::abs(nudge);
                EXPECT_NEAR((grain.support(direction) + grain.givenCentroid()).dot(direction), furthest,
                            slack)
                    << i << ' ' << nudge;
                EXPECT_NEAR((polygon.support(direction) + polygon.givenCentroid()).dot(direction), furthest,
                            slack)
                    << i << ' ' << nudge;
            }
            std::rotate(vertices.begin(), vertices.begin() + 1, vertices.end());
        }
    }
}

TEST(PolyBezier, aPiecewiseStraightGrainIsThePolygon)
{
    test::RandomSource random(51);
    const ConvexPolygon polygon = test::randomPolygon(7, 1, random);
    const PolyBezier grain(test::polygonSegments(polygon.vertices()));
    for (int i = 0; i < 10000; ++i)
    {
        const Vector2 direction = random.direction();
        EXPECT_NEAR(grain.support(direction).dot(direction), polygon.support(direction).dot(direction),
                    4 * epsilon);
    }
    EXPECT_NEAR(grain.massProperties().area, polygon.massProperties().area, 16 * epsilon);
}

TEST(PolyBezier, centringKeepsACentredGrainToTheBit)
{
    test::RandomSource random(52);
    for (int i = 0; i < 200; ++i)
    {
        test::RandomGrainOptions options;
        options.radius = random.logUniform(1e-5, 1e3);
        options.segments = random.integer(5, 40);
        const PolyBezier once = test::randomPolyBezier(options, random);
        const PolyBezier twice(once.segments());
        for (std::size_t k = 0; k < once.segments().size(); ++k)
        {
            ASSERT_EQ(once.segments()[k].controlPoints(), twice.segments()[k].controlPoints())
                << "grain " << i;
        }
    }
}

TEST(PolyBezier, centringFindsTheCentroidOfAGrainFarAway)
{
    const Vector2 away(1024, -512);
    const PolyBezier here(test::ellipseSegments(16, 2, 1));
    const PolyBezier there(test::ellipseSegments(16, 2, 1, away));
    EXPECT_LT((there.givenCentroid() - away).norm(), 1e-12);
    const test::PreciseMoments moments = test::preciseMoments(there.segments());
    EXPECT_LT(std::hypot(moments.first.x, moments.first.y) / moments.area, 1e-15L);
    EXPECT_NEAR(there.massProperties().polarMoment, here.massProperties().polarMoment, 1e-11);
}
