#pragma once

#include "core/base/vector.hpp"

#include <vector>

namespace chesil
{

/// The lines through the edges of a convex polygon, given counter-clockwise, for fast distances. The
/// distance of a point is taken to the line that it is furthest out of: exact inside and beside the edges;
/// outside a vertex too small by the cosine of half the turn there at most.
class EdgeLines
{
public:
    struct Distance
    {
        /// Positive outside, in the unit of the polygon.
        double value;
        /// Of the line, outward: the gradient of the distance.
        Vector2 normal;
    };

    explicit EdgeLines(const std::vector<Vector2>& polygon);

    Distance distance(const Vector2& point) const
    {
        Eigen::Index furthest = 0;
        const double value = (normals_ * point - offsets_).maxCoeff(&furthest);
        return {value, normals_.row(furthest).transpose()};
    }

private:
    Eigen::Matrix<double, Eigen::Dynamic, 2> normals_;
    Eigen::VectorXd offsets_;
};

} // namespace chesil
