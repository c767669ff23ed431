#include "core/shapes/shape.hpp"
#include "coupling/geometry/solidFraction.hpp"
#include "unit/coupling/testMeshes.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

using namespace chesil;
using namespace chesil::test;

namespace
{

constexpr int poses = 1000;
constexpr std::uint64_t seed = 20240601;
constexpr double bar = 1e-12;

Shape randomShape(const std::string& kind, RandomSource& random)
{
    if (kind == "circle")
    {
        return Circle(random.uniform(0.8, 1.2));
    }
    if (kind == "ellipse")
    {
        return Ellipse(random.uniform(0.3, 1.2), random.uniform(0.3, 1.2));
    }
    if (kind == "polygon")
    {
        return randomPolygon(random.integer(4, 7), 1, random);
    }
    RandomGrainOptions options;
    options.straight = random.integer(0, 2);
    options.nearlyStraight = random.integer(0, 2);
    options.segments = random.integer(5, 10) + options.straight + options.nearlyStraight;
    return randomPolyBezier(options, random);
}

/// A mesh of 6 m x 6 m about `centre` [m] with cells of the size `width` [m], for grains of about 1 m.
CellView randomMesh(const std::string& kind, const Vector2& centre, double width, RandomSource& random)
{
    const double stretch = kind == "stretched" ? std::sqrt(20.0) : 1;
    const Vector2 wanted(width * stretch, width / stretch);
    const int columns = static_cast<int>(std::ceil(6 / wanted.x()));
    const int rows = static_cast<int>(std::ceil(6 / wanted.y()));
    const PointGrid grid(centre - Vector2(3, 3), Vector2(6.0 / columns, 6.0 / rows), columns, rows,
                         kind == "triangles" ? 0.2 : 0, random);
    return kind == "triangles" ? triangleMesh(grid) : quadrilateralMesh(grid);
}

struct Sums
{
    double area = 0;
    Vector2 first = Vector2::Zero();
};

Sums sumsOver(const GrainCells& grain)
{
    Sums sums;
    for (const CoveredCell& covered : grain.cells())
    {
        sums.area += covered.area;
        sums.first += covered.firstMoment;
    }
    return sums;
}

/// What must hold on any mesh, whatever the pose.
void expectSane(const GrainCells& grain, const CellView& mesh)
{
    int last = -1;
    for (const CoveredCell& covered : grain.cells())
    {
        ASSERT_GT(covered.cell, last);
        ASSERT_GT(covered.area, 0);
        ASSERT_LE(covered.area, mesh.area(covered.cell));
        last = covered.cell;
    }
}

struct LargestErrors
{
    /// Relative to the grain's area.
    double area = 0;
    /// The centroid's, relative to the bounding radius.
    double centroid = 0;
};

/// 1,000 random poses of random grains on ten meshes, each up to 1e3 grain sizes from the origin, with cells
/// from 1/20 of a grain's diameter to a cell larger than the grain.
LargestErrors errorsOfSums(const std::string& meshKind, const std::string& shapeKind)
{
    constexpr int meshes = 10;
    RandomSource random(seed);
    GrainCells grain;
    LargestErrors largest;
    for (int m = 0; m < meshes; ++m)
    {
        const Vector2 centre = random.direction() * (m == 0 ? 0 : random.logUniform(1, 1e3));
        const CellView mesh = randomMesh(meshKind, centre, m == 1 ? 6 : random.logUniform(0.1, 1), random);
        for (int i = 0; i < poses / meshes; ++i)
        {
            const Shape shape = randomShape(shapeKind, random);
            Pose<2> pose = random.pose(1);
            pose.position += centre;
            grain.update(outline(shape), pose, mesh);
            expectSane(grain, mesh);
            const double area = massProperties(shape).area;
            const Sums sums = sumsOver(grain);
            largest.area = std::max(largest.area, std::abs(sums.area / area - 1));
            largest.centroid = std::max(largest.centroid, sums.first.norm() / (area * boundingRadius(shape)));
        }
    }
    std::printf("solid fraction, %s on %s, %d poses, seed %llu: largest relative error of area %.2e, of "
                "centroid %.2e\n",
                shapeKind.c_str(), meshKind.c_str(), poses, static_cast<unsigned long long>(seed),
                largest.area, largest.centroid);
    return largest;
}

/// The bar 'Solid fraction' of the project's first issue.
void expectBarMet(const std::string& meshKind, const std::string& recordedAs)
{
    double worst = 0;
    for (const std::string shapeKind : {"circle", "ellipse", "polygon", "polybezier"})
    {
        const LargestErrors largest = errorsOfSums(meshKind, shapeKind);
        EXPECT_LE(largest.area, bar) << shapeKind;
        EXPECT_LE(largest.centroid, bar) << shapeKind;
        worst = std::max(worst, largest.area);
    }
    record("firstLight", recordedAs, worst, "-");
}

} // namespace

TEST(SolidFraction, sumsToTheGrainsAreaOnSquares) { expectBarMet("squares", "solidFractionSquareMesh"); }

TEST(SolidFraction, sumsToTheGrainsAreaOnStretchedCells)
{
    expectBarMet("stretched", "solidFractionStretchedMesh");
}

TEST(SolidFraction, sumsToTheGrainsAreaOnTriangles)
{
    expectBarMet("triangles", "solidFractionTriangleMesh");
}

/// Outlines tangent to grid lines, joints and corners on lines and on grid points: every pose of this list
/// is a special one.
TEST(SolidFraction, sumHoldsInSpecialPoses)
{
    RandomSource random(1);
    const CellView mesh = quadrilateralMesh(PointGrid({-3, -3}, {0.25, 0.25}, 24, 24, 0, random));
    const CellView triangles = triangleMesh(PointGrid({-3, -3}, {0.25, 0.25}, 24, 24, 0, random));
    const std::vector<Shape> shapes{
        Circle(1),
        Circle(0.125),
        Circle(0.05),
        Ellipse(1, 0.5),
        ConvexPolygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}),
        ConvexPolygon({{-0.25, -0.25}, {0.25, -0.25}, {0.25, 0.25}, {-0.25, 0.25}}),
        ConvexPolygon({{0, -1}, {1, 0}, {0, 1}, {-1, 0}})};
    GrainCells grain;
    for (const Shape& shape : shapes)
    {
        for (const double x : {0.0, 0.125, 0.25, 0.05, std::nextafter(0.25, 0), std::nextafter(0.25, 1)})
        {
            for (int quarter = 0; quarter < 8; ++quarter)
            {
                const Pose<2> pose{Vector2(x, 0.25 - x), Rotation<2>(quarter * M_PI / 4)};
                for (const CellView* view : {&mesh, &triangles})
                {
                    grain.update(outline(shape), pose, *view);
                    expectSane(grain, *view);
                    const double area = massProperties(shape).area;
                    ASSERT_NEAR(sumsOver(grain).area / area, 1, bar)
                        << std::visit([](const auto& s) { return s.typeName; }, shape) << " at " << x
                        << " turned by " << quarter;
                }
            }
        }
    }
}

TEST(SolidFraction, squareOnSquaresCoversWholeCellsAlone)
{
    RandomSource random(1);
    const CellView mesh = quadrilateralMesh(PointGrid({0, 0}, {1, 1}, 6, 6, 0, random));
    const ConvexPolygon square({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    GrainCells grain;
    grain.update(square.outline(), {Vector2(3, 2), Rotation<2>()}, mesh);
    std::vector<int> cells;
    for (const CoveredCell& covered : grain.cells())
    {
        cells.push_back(covered.cell);
        EXPECT_EQ(covered.area, 1);
    }
    EXPECT_EQ(cells, (std::vector<int>{8, 9, 14, 15}));
    EXPECT_EQ(grain.cells().front().firstMoment, Vector2(-0.5, -0.5));
}

TEST(SolidFraction, cellInsideTheGrainKeepsItsAreaToTheBit)
{
    RandomSource random(3);
    const CellView mesh = triangleMesh(PointGrid({-1.5, -1.5}, {0.1, 0.1}, 30, 30, 0.2, random));
    GrainCells grain;
    grain.update(Circle(1).outline(), {Vector2::Zero(), Rotation<2>(0.3)}, mesh);
    int whole = 0;
    for (const CoveredCell& covered : grain.cells())
    {
        double furthest = 0;
        for (const Vector2& corner : mesh.polygon(covered.cell))
        {
            furthest = std::max(furthest, corner.norm());
        }
        EXPECT_EQ(covered.area == mesh.area(covered.cell), furthest <= 1) << "cell " << covered.cell;
        whole += furthest <= 1 ? 1 : 0;
    }
    EXPECT_GT(whole, 400);
}

TEST(SolidFraction, grainAcrossTheMeshsEdgeIsCoveredWithinAlone)
{
    RandomSource random(5);
    const CellView mesh = quadrilateralMesh(PointGrid({0, 0}, {0.1, 0.1}, 20, 20, 0, random));
    const CellView whole = oneCell({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    GrainCells grain;
    for (int i = 0; i < 100; ++i)
    {
        const Outline curve = outline(randomShape("polybezier", random));
        const Pose<2> pose = random.pose(2);
        grain.update(curve, pose, mesh);
        const double area = sumsOver(grain).area;
        grain.update(curve, pose, whole);
        EXPECT_NEAR(area, sumsOver(grain).area, 1e-13);
    }
    grain.update(Circle(1).outline(), {Vector2(5, 5), Rotation<2>()}, mesh);
    EXPECT_TRUE(grain.cells().empty());
    grain.update(Circle(1).outline(), {Vector2(-1, 1), Rotation<2>()}, mesh);
    EXPECT_TRUE(grain.cells().empty()) << "touches the mesh in one point";
}

/// The same grain and mesh, moved by a power of two: the same bits in each cell.
TEST(SolidFraction, doesNotDependOnTheOrigin)
{
    RandomSource random(8);
    const Shape shape = randomShape("polybezier", random);
    GrainCells near;
    GrainCells far;
    const auto update = [&](GrainCells& grain, const Vector2& origin)
    {
        RandomSource same(9);
        const CellView mesh = quadrilateralMesh(PointGrid(origin, {0.125, 0.125}, 32, 32, 0, same));
        grain.update(outline(shape), {origin + Vector2(2.0625, 1.9375), Rotation<2>(0.7)}, mesh);
    };
    update(near, Vector2::Zero());
    update(far, Vector2(0x1p40, -0x1p40));
    ASSERT_EQ(near.cells().size(), far.cells().size());
    for (std::size_t i = 0; i < near.cells().size(); ++i)
    {
        EXPECT_EQ(near.cells()[i].area, far.cells()[i].area);
        EXPECT_EQ(near.cells()[i].firstMoment, far.cells()[i].firstMoment);
    }
}
