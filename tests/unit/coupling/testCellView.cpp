#include "core/base/setupError.hpp"
#include "unit/coupling/testMeshes.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;
using namespace chesil::test;

namespace
{

/// Cells that grow by a constant factor along x and y, from 1 m to about 100 m.
CellView gradedMesh(int count)
{
    const double growth = std::pow(100.0, 1.0 / count);
    std::vector<double> lines{0};
    for (int i = 0; i < count; ++i)
    {
        lines.push_back(lines.back() + std::pow(growth, i));
    }
    std::vector<int> offsets{0};
    std::vector<Vector2> vertices;
    for (int j = 0; j < count; ++j)
    {
        for (int i = 0; i < count; ++i)
        {
            vertices.emplace_back(lines[i], lines[j]);
            vertices.emplace_back(lines[i + 1], lines[j]);
            vertices.emplace_back(lines[i + 1], lines[j + 1]);
            vertices.emplace_back(lines[i], lines[j + 1]);
            offsets.push_back(static_cast<int>(vertices.size()));
        }
    }
    return CellView(offsets, vertices);
}

std::vector<int> overlappingByAll(const CellView& mesh, const Box& query)
{
    std::vector<int> found;
    for (int cell = 0; cell < mesh.size(); ++cell)
    {
        if (mesh.box(cell).overlaps(query))
        {
            found.push_back(cell);
        }
    }
    return found;
}

/// Random queries of sizes from far below a cell to the whole mesh, against a look at every cell.
void expectQueriesRight(const CellView& mesh, RandomSource& random)
{
    Box bounds;
    for (int cell = 0; cell < mesh.size(); ++cell)
    {
        bounds.add(mesh.box(cell));
    }
    const Vector2 span = bounds.high - bounds.low;
    std::vector<int> found;
    for (int i = 0; i < 300; ++i)
    {
        const Vector2 share(random.uniform(-0.2, 1.2), random.uniform(-0.2, 1.2));
        const Vector2 low = bounds.low + share.cwiseProduct(span);
        const Vector2 size(random.logUniform(1e-5, 2), random.logUniform(1e-5, 2));
        const Box query{low, low + size.cwiseProduct(span)};
        mesh.cellsOverlapping(query, found);
        ASSERT_EQ(found, overlappingByAll(mesh, query)) << "query " << i;
    }
}

std::string foundBy(const std::vector<int>& offsets, const std::vector<Vector2>& vertices)
{
    try
    {
        CellView(offsets, vertices);
    }
    catch (const ValueError& error)
    {
        return error.found();
    }
    return "nothing wrong";
}

} // namespace

TEST(CellView, measuresItsCells)
{
    const CellView mesh({0, 3, 7}, {{1, 1}, {3, 1}, {1, 4}, {0, 0}, {4, 0}, {4, 1}, {0, 1}});
    EXPECT_EQ(mesh.size(), 2);
    EXPECT_DOUBLE_EQ(mesh.area(0), 3);
    EXPECT_DOUBLE_EQ(mesh.centre(0).x(), 5.0 / 3);
    EXPECT_DOUBLE_EQ(mesh.centre(0).y(), 2);
    EXPECT_DOUBLE_EQ(mesh.width(1), 2);
    EXPECT_EQ(mesh.polygon(1).size(), 4);
    EXPECT_EQ(mesh.polygon(1)[2], Vector2(4, 1));
}

TEST(CellView, measuresFarFromTheOrigin)
{
    // Every coordinate is a binary number, so that the far cell is the near one to the bit.
    const Vector2 far(0x1p30, -0x1p30);
    const CellView mesh =
        oneCell({far, far + Vector2(0.5, 0), far + Vector2(0.5, 0.25), far + Vector2(0, 0.25)});
    EXPECT_DOUBLE_EQ(mesh.area(0), 0.125);
    EXPECT_EQ(mesh.centre(0), far + Vector2(0.25, 0.125));
}

TEST(CellView, findsCellsOnAnyMesh)
{
    RandomSource random(11);
    expectQueriesRight(quadrilateralMesh(PointGrid({-3, 2}, {0.1, 0.1}, 40, 30, 0, random)), random);
    expectQueriesRight(quadrilateralMesh(PointGrid({-3, 2}, {2, 0.1}, 10, 120, 0.2, random)), random);
    expectQueriesRight(triangleMesh(PointGrid({1e3, 2e3}, {0.1, 0.1}, 30, 30, 0.25, random)), random);
    expectQueriesRight(gradedMesh(40), random);
    expectQueriesRight(oneCell({{0, 0}, {1, 0}, {0, 1}}), random);
}

TEST(CellView, findsCellsThatOnlyTouchTheQuery)
{
    RandomSource random(1);
    const CellView mesh = quadrilateralMesh(PointGrid({0, 0}, {1, 1}, 4, 4, 0, random));
    std::vector<int> found;
    mesh.cellsOverlapping({{1, 1}, {2, 2}}, found);
    EXPECT_EQ(found, (std::vector<int>{0, 1, 2, 4, 5, 6, 8, 9, 10}));
}

TEST(CellView, findsNothingOutsideOrWithoutCells)
{
    std::vector<int> found{5};
    oneCell({{0, 0}, {1, 0}, {0, 1}}).cellsOverlapping({{2, 2}, {3, 3}}, found);
    EXPECT_TRUE(found.empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    oneCell({{0, 0}, {1, 0}, {0, 1}}).cellsOverlapping({{nan, 0}, {1, 1}}, found);
    EXPECT_TRUE(found.empty());
    CellView({0}, {}).cellsOverlapping({{0, 0}, {1, 1}}, found);
    EXPECT_TRUE(found.empty());
    CellView().cellsOverlapping({{0, 0}, {1, 1}}, found);
    EXPECT_TRUE(found.empty());
}

TEST(CellView, reusesTheListItIsGiven)
{
    RandomSource random(1);
    const CellView mesh = quadrilateralMesh(PointGrid({0, 0}, {1, 1}, 20, 20, 0, random));
    std::vector<int> found;
    found.reserve(400);
    const int* storage = found.data();
    for (int i = 0; i < 20; ++i)
    {
        mesh.cellsOverlapping({{0.5 * i, 0}, {20, 20}}, found);
        ASSERT_EQ(found.data(), storage);
    }
}

TEST(CellView, namesTheCellThatIsWrong)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vector2> good{{0, 0}, {1, 0}, {0, 1}};
    const auto withSecond = [&](std::vector<Vector2> second)
    {
        std::vector<Vector2> vertices = good;
        vertices.insert(vertices.end(), second.begin(), second.end());
        return foundBy({0, 3, static_cast<int>(vertices.size())}, vertices);
    };
    EXPECT_EQ(withSecond({{0, 0}, {1, 0}, {1, 1}}), "nothing wrong");
    EXPECT_NE(withSecond({{0, 0}, {0, 1}, {1, 0}}).find("cell 1"), std::string::npos);
    EXPECT_NE(withSecond({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}).find("not convex"), std::string::npos);
    EXPECT_NE(withSecond({{0, 0}, {nan, 0}, {0, 1}}).find("not a number"), std::string::npos);
    EXPECT_NE(withSecond({{0, 0}, {1, 0}}).find("fewer than three"), std::string::npos);
    EXPECT_NE(foundBy({0, 3, 3}, good).find("cell 1 without corners"), std::string::npos);
    EXPECT_NE(foundBy({0, 4}, good).find("end with 4"), std::string::npos);
    EXPECT_NE(foundBy({}, {}).find("begin with 0"), std::string::npos);
}
