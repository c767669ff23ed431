#include "core/shapes/shape.hpp"
#include "coupling/geometry/solidFraction.hpp"
#include "unit/coupling/testMeshes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

namespace chesil
{

namespace
{

/// Flow solvers trap these (OpenFOAM's FOAM_SIGFPE): a division by zero that no comparison would accept still ends
/// the run.
class TrappedArithmetic : public ::testing::Test
{
protected:
    TrappedArithmetic() { feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW); }

    ~TrappedArithmetic() override
    {
        std::feclearexcept(FE_ALL_EXCEPT);
        fedisableexcept(FE_ALL_EXCEPT);
    }
};

/// Square cells of width 0.25 covering [-2, 2] x [-2, 2].
CellView unitSquares()
{
    std::vector<int> offsets{0};
    std::vector<Vector2> vertices;
    for (int row = -8; row < 8; ++row)
    {
        for (int column = -8; column < 8; ++column)
        {
            for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            {
                vertices.emplace_back(0.25 * (column + dx), 0.25 * (row + dy));
            }
            offsets.push_back(static_cast<int>(vertices.size()));
        }
    }
    return CellView(offsets, vertices);
}

double coveredArea(const Shape& shape, const Pose<2>& pose, const CellView& mesh)
{
    GrainCells cells;
    cells.update(outline(shape), pose, mesh);
    double sum = 0;
    for (const CoveredCell& covered : cells.cells())
    {
        sum += covered.area;
    }
    return sum;
}

/// Four mirror-symmetric segments, so that distances to an axis-parallel line have a - 2b + c = 0 exactly.
PolyBezier symmetricGrain()
{
    const double k = 0.5;
    return PolyBezier({
        CubicBezier({Vector2(1, -1), Vector2(1 + k, -k), Vector2(1 + k, k), Vector2(1, 1)}),
        CubicBezier({Vector2(1, 1), Vector2(k, 1 + k), Vector2(-k, 1 + k), Vector2(-1, 1)}),
        CubicBezier({Vector2(-1, 1), Vector2(-1 - k, k), Vector2(-1 - k, -k), Vector2(-1, -1)}),
        CubicBezier({Vector2(-1, -1), Vector2(-k, -1 - k), Vector2(k, -1 - k), Vector2(1, -1)}),
    });
}

} // namespace

TEST_F(TrappedArithmetic, symmetricGrainOnAxisParallelEdges)
{
    const CellView mesh = unitSquares();
    const PolyBezier grain = symmetricGrain();
    EXPECT_NEAR(coveredArea(grain, {}, mesh), grain.massProperties().area, 1e-12);
}

TEST_F(TrappedArithmetic, tilesWithEdgesOnGridLines)
{
    const CellView mesh = unitSquares();
    for (const double shift : {0.0, 0.25, 0.125})
    {
        const ConvexPolygon tile({Vector2(0, 0), Vector2(1, 0), Vector2(1, 0.5), Vector2(0, 0.5)});
        EXPECT_NEAR(coveredArea(tile, {Vector2(shift, shift), {}}, mesh), 0.5, 1e-13);
    }
}

TEST_F(TrappedArithmetic, roundShapesOnGridLines)
{
    const CellView mesh = unitSquares();
    EXPECT_NEAR(coveredArea(Circle(1), {}, mesh), M_PI, 1e-12);
    EXPECT_NEAR(coveredArea(Ellipse(1, 0.5), {}, mesh), M_PI / 2, 1e-12);
    EXPECT_NEAR(coveredArea(Ellipse(1, 0.5), {Vector2(0.25, 0), Rotation<2>(M_PI / 2)}, mesh), M_PI / 2, 1e-12);
}

TEST_F(TrappedArithmetic, randomGrainsTurnedByQuarters)
{
    const CellView mesh = unitSquares();
    test::RandomSource random(7);
    for (int i = 0; i < 200; ++i)
    {
        test::RandomGrainOptions options;
        options.straight = i % 3;
        const PolyBezier grain = test::randomPolyBezier(options, random);
        const double scale = 1 / grain.boundingRadius();
        std::vector<CubicBezier> segments;
        for (const CubicBezier& segment : grain.segments())
        {
            segments.push_back(segment.transformed(Vector2::Zero(), 1, 0, scale));
        }
        const PolyBezier small(segments);
        const Pose<2> pose{Vector2(0.25 * (i % 4), 0), Rotation<2>(M_PI / 2 * (i % 5))};
        EXPECT_NEAR(coveredArea(small, pose, mesh), small.massProperties().area, 1e-12) << "grain " << i << " of seed 7";
    }
}

} // namespace chesil
