#include "generate/fit/edgeLines.hpp"

namespace chesil
{

EdgeLines::EdgeLines(const std::vector<Vector2>& polygon)
    : normals_(polygon.size(), 2), offsets_(polygon.size())
{
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        const Vector2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
        const Vector2 normal = -perpendicular(edge).normalized();
        const auto row = static_cast<Eigen::Index>(i);
        normals_.row(row) = normal.transpose();
        offsets_[row] = normal.dot(polygon[i]);
    }
}

} // namespace chesil
