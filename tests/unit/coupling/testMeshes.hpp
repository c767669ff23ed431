#pragma once

#include "coupling/cellView/cellView.hpp"
#include "unit/randomGrain.hpp"

#include <vector>

/// Plane meshes for the tests of the coupling.
namespace chesil::test
{

/// columns x rows points that cut a rectangle [m] into quadrilaterals; inner points are moved at random by
/// up to `shake` of the spacing.
class PointGrid
{
public:
    PointGrid(const Vector2& low, const Vector2& spacing, int columns, int rows, double shake,
              RandomSource& random)
        : columns_(columns), rows_(rows)
    {
        for (int j = 0; j <= rows; ++j)
        {
            for (int i = 0; i <= columns; ++i)
            {
                const bool inner = i > 0 && i < columns && j > 0 && j < rows;
                const double reach = inner ? shake : 0;
                const double dx = random.uniform(-reach, reach);
                const double dy = random.uniform(-reach, reach);
                points_.push_back(low + Vector2((i + dx) * spacing.x(), (j + dy) * spacing.y()));
            }
        }
    }

    int columns() const { return columns_; }
    int rows() const { return rows_; }

    const Vector2& point(int i, int j) const { return points_[j * (columns_ + 1) + i]; }

private:
    int columns_;
    int rows_;
    std::vector<Vector2> points_;
};

inline CellView quadrilateralMesh(const PointGrid& grid)
{
    std::vector<int> offsets{0};
    std::vector<Vector2> vertices;
    for (int j = 0; j < grid.rows(); ++j)
    {
        for (int i = 0; i < grid.columns(); ++i)
        {
            for (const Vector2& p :
                 {grid.point(i, j), grid.point(i + 1, j), grid.point(i + 1, j + 1), grid.point(i, j + 1)})
            {
                vertices.push_back(p);
            }
            offsets.push_back(static_cast<int>(vertices.size()));
        }
    }
    return CellView(std::move(offsets), std::move(vertices));
}

/// Each quadrilateral halved by a diagonal, the two directions in turn.
inline CellView triangleMesh(const PointGrid& grid)
{
    std::vector<int> offsets{0};
    std::vector<Vector2> vertices;
    const auto add = [&](const Vector2& a, const Vector2& b, const Vector2& c)
    {
        vertices.insert(vertices.end(), {a, b, c});
        offsets.push_back(static_cast<int>(vertices.size()));
    };
    for (int j = 0; j < grid.rows(); ++j)
    {
        for (int i = 0; i < grid.columns(); ++i)
        {
            const Vector2& a = grid.point(i, j);
            const Vector2& b = grid.point(i + 1, j);
            const Vector2& c = grid.point(i + 1, j + 1);
            const Vector2& d = grid.point(i, j + 1);
            if ((i + j) % 2 == 0)
            {
                add(a, b, c);
                add(a, c, d);
            }
            else
            {
                add(a, b, d);
                add(b, c, d);
            }
        }
    }
    return CellView(std::move(offsets), std::move(vertices));
}

/// A single cell.
inline CellView oneCell(const std::vector<Vector2>& corners)
{
    return CellView({0, static_cast<int>(corners.size())}, corners);
}

} // namespace chesil::test
