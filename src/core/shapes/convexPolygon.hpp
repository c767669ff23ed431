#pragma once

#include "core/base/supportContract.hpp"
#include "core/base/vector.hpp"
#include "core/geometry/outline.hpp"
#include "core/shapes/massProperties.hpp"
#include "core/shapes/normalTable.hpp"

#include <algorithm>
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

    /// The vertex furthest along `direction`.
    std::size_t supportVertex(const Vector2& direction) const { return normals_.find(direction); }
    Vector2 support(const Vector2& direction) const { return vertices_[supportVertex(direction)]; }

    double boundingRadius() const { return boundingRadius_; }

    /// Side i from vertex i on.
    const std::vector<StraightSide>& sides() const { return sides_; }

    CurvedPoint<2> curvedSupport(const Vector2& normal) const
    {
        const std::size_t vertex = supportVertex(normal);
        const double before = cross(sides_[vertex == 0 ? sides_.size() - 1 : vertex - 1].normal, normal);
        const double after = cross(normal, sides_[vertex].normal);
        return {vertices_[vertex], {}, std::max(0.0, std::min(before, after))};
    }
    static double leastRadiusBetween(const Vector2&, const Vector2&) { return 0; }
    double leastRadius() const { return 0; }
    double innerRadius() const { return innerRadius_; }
    static constexpr bool mayHaveStraightSides = true;
    static constexpr bool hasStraightSides() { return true; }
    const StraightSide* straightSideFacing(const Vector2& normal) const;
    const StraightSide* straightSideBetween(const Vector2& from, const Vector2& to) const;

    MassProperties massProperties() const { return mass_; }
    Outline outline() const;

private:
    std::vector<Vector2> vertices_;
    Vector2 givenCentroid_ = Vector2::Zero();
    std::vector<StraightSide> sides_;
    NormalTable normals_;
    double innerRadius_ = 0;
    double boundingRadius_ = 0;
    MassProperties mass_;
};

} // namespace chesil
