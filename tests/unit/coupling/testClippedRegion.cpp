#include "core/shapes/shape.hpp"
#include "coupling/geometry/clippedRegion.hpp"
#include "coupling/geometry/solidFraction.hpp"
#include "unit/coupling/areaReference.hpp"
#include "unit/coupling/testMeshes.hpp"

#include <gtest/gtest.h>

using namespace chesil;
using namespace chesil::test;

namespace
{

CellView rectangle(double x0, double y0, double x1, double y1)
{
    return oneCell({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

/// What a grain covers of a mesh of one cell; zero if it touches no more than its edge.
CoveredCell coveredPart(const Outline& outline, const Pose<2>& pose, const CellView& cell)
{
    GrainCells grain;
    grain.update(outline, pose, cell);
    return grain.cells().empty() ? CoveredCell() : grain.cells().front();
}

double coveredArea(const Outline& outline, const CellView& cell)
{
    return coveredPart(outline, Pose<2>(), cell).area;
}

/// A convex cell with 3 to 6 corners about a place near the rim of a grain of about 1 m.
CellView randomCell(RandomSource& random)
{
    const Vector2 centre = random.uniform(0, 1.3) * random.direction();
    const ConvexPolygon polygon = randomPolygon(random.integer(3, 6), random.logUniform(0.02, 2), random);
    std::vector<Vector2> corners;
    for (const Vector2& corner : polygon.vertices())
    {
        corners.push_back(centre + corner);
    }
    return oneCell(corners);
}

/// A disk of radius 1 as four cubic segments, each within 2.8e-4 of the circle.
PolyBezier roundedByFour()
{
    constexpr double arm = 0.5522847498307936;
    std::vector<CubicBezier> segments;
    for (int i = 0; i < 4; ++i)
    {
        const CubicBezier first({Vector2(1, 0), Vector2(1, arm), Vector2(arm, 1), Vector2(0, 1)});
        const double cosine[] = {1, 0, -1, 0};
        const double sine[] = {0, 1, 0, -1};
        segments.push_back(first.transformed(Vector2::Zero(), cosine[i], sine[i], 1));
    }
    return PolyBezier(segments);
}

} // namespace

TEST(ClippedRegion, quarterOfADisk)
{
    EXPECT_NEAR(coveredArea(Circle(1).outline(), rectangle(0, 0, 2, 2)), M_PI / 4, 1e-15);
    const CoveredCell quarter = coveredPart(Circle(1).outline(), Pose<2>(), rectangle(-2, 0, 0, 2));
    EXPECT_NEAR(quarter.firstMoment.x(), -1.0 / 3, 1e-15);
    EXPECT_NEAR(quarter.firstMoment.y(), 1.0 / 3, 1e-15);
}

TEST(ClippedRegion, segmentOfADisk)
{
    for (const double distance : {-0.999999, -0.5, 0.0, 1e-3, 0.3, 0.9, 0.999, 0.999999})
    {
        const double angle = 2 * std::acos(distance);
        const double area = (angle - std::sin(angle)) / 2;
        EXPECT_NEAR(coveredArea(Circle(1).outline(), rectangle(distance, -2, 3, 2)), area, 2e-15) << distance;
    }
}

TEST(ClippedRegion, capOfACubicThatBulgesThroughAnEdge)
{
    // The segment's both ends lie outside, its middle inside: (0, 0), (0, 4/3), (4, 4/3), (4, 0) rises to 1.
    const Vector2 a(0, 0), b(0, 4.0 / 3), c(4, 4.0 / 3), d(4, 0);
    const PolyBezier grain({CubicBezier({d, c, b, a}), CubicBezier({a, Vector2(0, -1), Vector2(4, -1), d})});
    const Vector2 shift = -grain.givenCentroid();
    // y(t) = 4 t (1 - t) = 3/4 at t = 1/4 and 3/4; the part's area is int (y - 3/4) x' dt with x' = 24 t (1 -
    // t).
    const double expected = 24 * (4 * (1.0 / 30 - 2 * 53.0 / 15360) - 0.75 * (1.0 / 6 - 2 * 5.0 / 192));
    const CellView cell = rectangle(shift.x() - 1, shift.y() + 0.75, shift.x() + 5, shift.y() + 2);
    EXPECT_NEAR(coveredArea(grain.outline(), cell), expected, 1e-14);
    const CellView above = rectangle(shift.x() - 1, shift.y() + 1, shift.x() + 5, shift.y() + 2);
    EXPECT_NEAR(coveredArea(grain.outline(), above), 0, 1e-20) << "tangent at the top";
    const CellView below = rectangle(shift.x() - 1, shift.y() - 2, shift.x() + 5, shift.y() + 1);
    EXPECT_NEAR(coveredArea(grain.outline(), below), grain.massProperties().area, 4e-15)
        << "tangent at the top";
}

TEST(ClippedRegion, tangentLinesLeaveAllOrNothing)
{
    for (const Outline& outline : {Circle(1).outline(), roundedByFour().outline()})
    {
        const double whole = coveredArea(outline, rectangle(-9, -9, 9, 9));
        for (const double shift : {0.0, 1e-16, -1e-16, 1e-15, -1e-15})
        {
            const double edge = 1 + shift;
            EXPECT_NEAR(coveredArea(outline, rectangle(edge, -2, 3, 2)), 0, 1e-20);
            EXPECT_NEAR(coveredArea(outline, rectangle(-edge, -edge, edge, edge)), whole, 2e-15);
        }
    }
}

TEST(ClippedRegion, edgesThroughJoints)
{
    const PolyBezier grain = roundedByFour();
    const double whole = grain.massProperties().area;
    EXPECT_NEAR(coveredArea(grain.outline(), rectangle(0, 0, 2, 2)), whole / 4, 2e-15);
    EXPECT_NEAR(coveredArea(grain.outline(), rectangle(0, -2, 2, 2)), whole / 2, 2e-15);
    EXPECT_NEAR(coveredArea(grain.outline(), oneCell({{1, 0}, {0, 1}, {-1, 0}, {0, -1}})), 2, 2e-15);
}

TEST(ClippedRegion, grainInsideACellAndCellInsideAGrain)
{
    RandomSource random(4);
    for (int i = 0; i < 100; ++i)
    {
        const PolyBezier grain = randomPolyBezier(RandomGrainOptions(), random);
        const Pose<2> pose = random.pose(1);
        const double area = grain.massProperties().area;
        const CoveredCell whole = coveredPart(grain.outline(), pose, rectangle(-9, -9, 9, 9));
        EXPECT_NEAR(whole.area, area, 4e-15);
        EXPECT_NEAR(whole.firstMoment.norm(), 0, 4e-15);
        const double x = pose.position.x();
        const double y = pose.position.y();
        const CellView small = rectangle(x - 0.1, y - 0.1, x + 0.1, y + 0.1);
        EXPECT_EQ(coveredPart(grain.outline(), pose, small).area, small.area(0));
    }
}

TEST(ClippedRegion, ellipsesAgreeWithTheUnitDisk)
{
    RandomSource random(21);
    double worst = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const Ellipse grain(random.uniform(0.2, 1.2), random.uniform(0.2, 1.2));
        const CellView cell = randomCell(random);
        const Pose<2> pose = random.pose(0.2);
        const double reference =
            static_cast<double>(areaInEllipse(cell.polygon(0), grain.a(), grain.b(), pose));
        const double found = coveredPart(grain.outline(), pose, cell).area;
        // Rounding of the outline's position along the cell.
        const double unit = std::max(1.0, cell.width(0)) * cell.width(0);
        ASSERT_NEAR(found / unit, reference / unit, 1e-14) << "cell " << i;
        worst = std::max(worst, std::abs(found - reference) / unit);
    }
    std::printf("ellipse and random cell: largest error %.1e of (size * cell width)\n", worst);
}

TEST(ClippedRegion, polygonsAgreeWithPolygonClipping)
{
    RandomSource random(22);
    for (int i = 0; i < 20000; ++i)
    {
        const ConvexPolygon grain = randomPolygon(random.integer(3, 8), 1, random);
        const CellView cell = randomCell(random);
        const Pose<2> pose = random.pose(0.2);
        LongPolygon polygon;
        for (const Vector2& vertex : grain.vertices())
        {
            polygon.push_back(longPoint(vertex) *
                              std::polar(1.0L, static_cast<long double>(pose.rotation.angle())));
        }
        const LongPolygon common = clipped(polygon, longPolygon(cell.polygon(0), pose.position));
        const CoveredCell found = coveredPart(grain.outline(), pose, cell);
        const double unit = std::max(1.0, cell.width(0)) * cell.width(0);
        ASSERT_NEAR(found.area / unit, static_cast<double>(polygonArea(common)) / unit, 1e-14)
            << "cell " << i;
        const LongPoint first = polygonFirstMoment(common);
        ASSERT_NEAR(found.firstMoment.x() / unit, static_cast<double>(first.real()) / unit, 1e-14)
            << "cell " << i;
        ASSERT_NEAR(found.firstMoment.y() / unit, static_cast<double>(first.imag()) / unit, 1e-14)
            << "cell " << i;
    }
}

TEST(ClippedRegion, polyBeziersAgreeWithFinePolygons)
{
    RandomSource random(23);
    for (int i = 0; i < 20; ++i)
    {
        RandomGrainOptions options;
        options.straight = i % 3;
        options.nearlyStraight = i % 2;
        const PolyBezier grain = randomPolyBezier(options, random);
        const Pose<2> pose = random.pose(0.2);
        const LongPolygon coarse = finePolygon(grain.outline(), pose.rotation.angle(), 1000);
        const LongPolygon fine = finePolygon(grain.outline(), pose.rotation.angle(), 2000);
        for (int k = 0; k < 5; ++k)
        {
            const CellView cell = randomCell(random);
            const LongPolygon corners = longPolygon(cell.polygon(0), pose.position);
            const LongPolygon partCoarse = clipped(coarse, corners);
            const LongPolygon partFine = clipped(fine, corners);
            // The chords' deficit falls with the square of their number, except where an edge cuts a chord:
            // two chords' slivers, 1e-10 m2, remain.
            const auto refined = [](long double atFine, long double atCoarse)
            { return static_cast<double>(atFine + (atFine - atCoarse) / 3); };
            const LongPoint firstCoarse = polygonFirstMoment(partCoarse);
            const LongPoint firstFine = polygonFirstMoment(partFine);
            const CoveredCell found = coveredPart(grain.outline(), pose, cell);
            EXPECT_NEAR(found.area, refined(polygonArea(partFine), polygonArea(partCoarse)), 1e-9)
                << i << " " << k;
            EXPECT_NEAR(found.firstMoment.x(), refined(firstFine.real(), firstCoarse.real()), 1e-9)
                << i << " " << k;
            EXPECT_NEAR(found.firstMoment.y(), refined(firstFine.imag(), firstCoarse.imag()), 1e-9)
                << i << " " << k;
        }
    }
}

/// What a line takes from one side it gives to the other; lines along tangents, at distances from rounding
/// to the grain's size, through joints too.
TEST(ClippedRegion, bothSidesOfALineAddUp)
{
    RandomSource random(25);
    TurnedOutline outline;
    ClippedRegion region;
    for (int i = 0; i < 2000; ++i)
    {
        RandomGrainOptions options;
        options.straight = i % 3;
        options.nearlyStraight = i % 2;
        const PolyBezier grain = randomPolyBezier(options, random);
        const Ellipse ellipse(random.uniform(0.2, 1), random.uniform(0.2, 1));
        const bool round = i % 4 == 0;
        outline.set(round ? ellipse.outline() : grain.outline(), Rotation<2>(random.uniform(-3, 3)));
        const double whole = round ? ellipse.massProperties().area : grain.massProperties().area;
        for (int k = 0; k < 20; ++k)
        {
            const int curve = random.integer(0, static_cast<int>(outline.curves().size()) - 1);
            const double share = k % 5 == 0 ? 0 : random.uniform(0, 1);
            const auto pointAndTangent = [&](double at) -> std::pair<Vector2, Vector2>
            {
                const OutlinePiece& piece = outline.curves()[curve];
                if (const auto* arc = std::get_if<EllipticArc>(&piece))
                {
                    const double angle = 2 * M_PI * at;
                    return {arc->at(angle), std::cos(angle) * arc->axisB - std::sin(angle) * arc->axisA};
                }
                const CubicBezier& segment = std::get<CubicBezier>(piece);
                return {segment.at(at), segment.derivative(at)};
            };
            const auto [point, tangent] = pointAndTangent(share);
            const double shift = k % 4 == 0 ? 0 : random.logUniform(1e-17, 1) * (k % 2 == 0 ? 1 : -1);
            const Vector2 through = point + shift * perpendicular(tangent);
            region.start(outline);
            region.cut({through, tangent});
            RegionMoments sum = region.moments();
            region.start(outline);
            region.cut({through, -tangent});
            sum += region.moments();
            ASSERT_NEAR(sum.area / whole, 1, 1e-14) << i << " " << k;
            ASSERT_NEAR(sum.first.norm() / whole, 0, 1e-14) << i << " " << k;
        }
    }
}

TEST(ClippedRegion, chainIsClosedAndEndsWhereItShould)
{
    TurnedOutline outline;
    outline.set(Circle(1).outline(), Rotation<2>());
    ClippedRegion region;
    region.start(outline);
    region.cut({Vector2(0, 0.5), Vector2(-1, 0)});
    ASSERT_FALSE(region.empty());
    EXPECT_FALSE(region.boundedByLines());
    const auto& pieces = region.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        EXPECT_EQ(pieces[i].end, pieces[(i + 1) % pieces.size()].start);
        EXPECT_LE(pieces[i].start.y(), 0.5 + 1e-15);
    }
    region.cut({Vector2(0, 0.5), Vector2(1, 0)});
    EXPECT_NEAR(region.moments().area, 0, 1e-15);
    region.cut({Vector2(0, 2), Vector2(1, 0)});
    EXPECT_TRUE(region.empty());
    EXPECT_EQ(region.moments().area, 0);
}
