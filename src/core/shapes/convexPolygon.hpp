#pragma once

#include "core/base/vector.hpp"
#include "core/geometry/outline.hpp"
#include "core/shapes/massProperties.hpp"
#include "core/shapes/normalTable.hpp"

#include <vector>

namespace chesil
{

/// A convex polygon. The vertices [m] are given counter-clockwise in any frame and are kept about the
/// centroid. Throws ValueError as requireConvex does.
class ConvexPolygon
{
public:
    static constexpr const char* typeName = "polygon";

    explicit ConvexPolygon(const std::vector<Vector2>& vertices);

    /// Counter-clockwise, about the centroid [m].
    const std::vector<Vector2>& vertices() const { return vertices_; }

    /// The centroid in the frame of the vertices given to the constructor [m].
    const Vector2& givenCentroid() const { return givenCentroid_; }

    Vector2 support(const Vector2& direction) const { return vertices_[normals_.find(direction)]; }

    double boundingRadius() const { return boundingRadius_; }

    MassProperties massProperties() const { return mass_; }
    Outline outline() const;

private:
    std::vector<Vector2> vertices_;
    Vector2 givenCentroid_ = Vector2::Zero();
    NormalTable normals_;
    double boundingRadius_ = 0;
    MassProperties mass_;
};

} // namespace chesil
