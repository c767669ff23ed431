#pragma once

#include "core/narrowphase/simplex.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace chesil
{

/// A facet of the polytope that EPA grows, as seen from the origin.
template <int Dim>
struct Facet
{
    /// Outward unit normal.
    Vector<Dim> normal;
    /// Distance of the facet's plane from the origin [m].
    double distance;
    int index;
};

template <int Dim>
class Polytope;

/// A counter-clockwise polygon inside A - B that holds the origin.
template <>
class Polytope<2>
{
public:
    static constexpr int capacity = 128;

    explicit Polytope(const Simplex<2>& triangle)
    {
        for (int i = 0; i < 3; ++i)
        {
            vertices_[index(i)] = triangle.vertices[index(i)];
        }
        size_ = 3;
        for (int i = 0; i < size_; ++i)
        {
            facets_[index(i)] = facetFrom(i);
        }
    }

    bool full() const { return size_ == capacity; }

    Facet<2> nearestFacet() const
    {
        int nearest = 0;
        for (int i = 1; i < size_; ++i)
        {
            if (facets_[index(i)].distance < facets_[index(nearest)].distance)
            {
                nearest = i;
            }
        }
        Facet<2> facet = facets_[index(nearest)];
        facet.index = nearest;
        return facet;
    }

    bool hasAsEnd(const Facet<2>& facet, const SupportVertex<2>& vertex) const
    {
        return vertices_[index(facet.index)].difference == vertex.difference
            || vertices_[index(after(facet.index))].difference == vertex.difference;
    }

    /// Puts a vertex between the two ends of a facet.
    void expand(const Facet<2>& facet, const SupportVertex<2>& vertex)
    {
        for (int i = size_; i > facet.index + 1; --i)
        {
            vertices_[index(i)] = vertices_[index(i - 1)];
            facets_[index(i)] = facets_[index(i - 1)];
        }
        vertices_[index(facet.index + 1)] = vertex;
        ++size_;
        facets_[index(facet.index)] = facetFrom(facet.index);
        facets_[index(facet.index + 1)] = facetFrom(facet.index + 1);
    }

    /// The point on A that belongs to the facet's point nearest the origin, relative to A's centroid [m].
    Vector2 pointOnA(const Facet<2>& facet) const
    {
        const SupportVertex<2>& a = vertices_[index(facet.index)];
        const SupportVertex<2>& b = vertices_[index(after(facet.index))];
        const Vector2 edge = b.difference - a.difference;
        const double share = std::clamp(-a.difference.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        return a.onA + share * (b.onA - a.onA);
    }

private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }

    int after(int i) const { return i + 1 == size_ ? 0 : i + 1; }

    Facet<2> facetFrom(int i) const
    {
        const Vector2& a = vertices_[index(i)].difference;
        const Vector2 outward = -perpendicular(vertices_[index(after(i))].difference - a);
        const double length = outward.norm();
        // An edge of no length has no normal: put last in the search.
        if (!(length > 0))
        {
            return {Vector2::UnitX(), std::numeric_limits<double>::infinity(), i};
        }
        const Vector2 normal = outward / length;
        return {normal, normal.dot(a), i};
    }

    std::array<SupportVertex<2>, capacity> vertices_;
    std::array<Facet<2>, capacity> facets_;
    int size_ = 0;
};

} // namespace chesil
