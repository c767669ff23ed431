#pragma once

#include "core/narrowphase/valley.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace chesil
{

/// How a sweep ended.
enum class SweepStatus
{
    /// No direction is less deep than the valley returned.
    proved,
    /// A direction separates the shapes.
    separated,
    /// Too many sectors: the valley is the best found.
    capacityReached,
    notFinite,
};

struct SweptValley
{
    SweepStatus status;
    Valley valley;
};

/// The deepest valley by branch and bound over all directions. A sector between two normals whose support points are
/// known has a lower bound of the height: that of the two points themselves, each drawn in by the least radius of
/// curvature of the sector (doc/contactKernel.md, "All directions"). The sector with the lowest bound is split until
/// none is below the best valley. This is EPA with curvature, over the whole turn.
template <class Difference>
class SectorSweep
{
public:
    SectorSweep(const Difference& difference, const Valley& first)
    : difference_(difference), floor_(tolerances::supportRounding / 2 * difference.size()), best_(first)
    {
        if (first.status != ValleyStatus::found)
        {
            best_.height = std::numeric_limits<double>::infinity();
        }
    }

    SweptValley run()
    {
        const Vector2 first = best_.normal;
        const std::array<Vector2, 4> normals{first, perpendicular(first), -first, -perpendicular(first)};
        std::array<Ray, 4> rays;
        for (std::size_t i = 0; i < 4; ++i)
        {
            if (!look(normals[i], rays[i]))
            {
                return {ended_, best_};
            }
        }
        for (std::size_t i = 0; i < 4; ++i)
        {
            add(rays[i], rays[(i + 1) % 4]);
        }
        while (true)
        {
            const auto lowest = std::min_element(
                sectors_.begin(), sectors_.begin() + static_cast<std::ptrdiff_t>(count_),
                [](const Sector& a, const Sector& b) { return a.bound < b.bound; });
            if (lowest->bound >= best_.height - floor_)
            {
                return {SweepStatus::proved, best_};
            }
            if (count_ == capacity)
            {
                return {SweepStatus::capacityReached, best_};
            }
            const Sector sector = *lowest;
            Ray middle;
            if (!look(sector.lowestNormal, middle))
            {
                return {ended_, best_};
            }
            *lowest = boundedSector(sector.first, middle);
            add(middle, sector.last);
        }
    }

private:
    /// Deep pairs settle with some twenty, the least lucky of ten million with less than half of it.
    static constexpr std::size_t capacity = 4096;

    /// A normal, its support point, and the stretch of bounded curvature that it lies on.
    struct Ray
    {
        Vector2 normal;
        Vector2 vertex;
        double height;
        OutlineStretch stretch;
    };

    struct Sector
    {
        Ray first;
        Ray last;
        double bound;
        /// Where the bound is, strictly inside; where to split.
        Vector2 lowestNormal;
    };

    /// Asks for the support point along a normal and follows it down if it is the least height so far. False if that ends
    /// the sweep.
    bool look(const Vector2& normal, Ray& ray)
    {
        const CurvedVertex<2> vertex = difference_.curvedSupport(normal);
        const double height = normal.dot(vertex.difference);
        if (!std::isfinite(height))
        {
            ended_ = SweepStatus::notFinite;
            return false;
        }
        ray = {normal, vertex.difference, height, difference_.narrowStretchAt(normal)};
        if (height < best_.height - floor_)
        {
            ValleySearch<Difference> search(difference_);
            const Valley valley = search.from(normal, SeparatedPairs::stop);
            const bool lower = valley.status != ValleyStatus::notFinite && valley.height < height;
            best_ = lower ? valley
                          : Valley{ValleyStatus::found, normal, height, vertex.onA, vertex.difference, vertex.difference, false};
            if (best_.height < 0)
            {
                ended_ = SweepStatus::separated;
                return false;
            }
        }
        return true;
    }

    void add(const Ray& first, const Ray& last) { sectors_[count_++] = boundedSector(first, last); }

    static bool holds(const OutlineStretch& stretch, const Vector2& normal)
    {
        return stretch.whole || (cross(stretch.firstNormal, normal) >= 0 && cross(normal, stretch.lastNormal) >= 0);
    }

    /// Radius of curvature that no point of the sector falls below.
    double leastRadius(const Ray& first, const Ray& last) const
    {
        // No larger than the shapes, so that drawing a point in costs no digits.
        const double everywhere = difference_.leastRadius();
        const double radius = std::min(first.stretch.leastRadius, difference_.size());
        return radius > everywhere && holds(first.stretch, last.normal) ? radius : everywhere;
    }

    /// The lowest value of the larger of n.p and n.q over the sector, p and q being the two points drawn in.
    Sector boundedSector(const Ray& first, const Ray& last) const
    {
        const double radius = leastRadius(first, last);
        const Vector2 p = first.vertex - radius * first.normal;
        const Vector2 q = last.vertex - radius * last.normal;
        Sector sector{first, last, std::min(first.height, last.height), unit(first.normal + last.normal)};
        const auto tryNormal = [&](const Vector2& direction)
        {
            const double length = direction.norm();
            if (!(length > 0))
            {
                return;
            }
            const Vector2 normal = direction / length;
            if (cross(first.normal, normal) > tolerances::sameNormal && cross(normal, last.normal) > tolerances::sameNormal)
            {
                const double height = std::max(normal.dot(p), normal.dot(q)) + radius;
                if (height < sector.bound)
                {
                    sector.bound = height;
                    sector.lowestNormal = normal;
                }
            }
        };
        // Where both are equal, and where either has its minimum.
        tryNormal(-perpendicular(q - p));
        tryNormal(-p);
        tryNormal(-q);
        return sector;
    }

    const Difference& difference_;
    /// Half of a support point's rounding: what the proof may leave, beside that of the depth itself.
    double floor_;
    Valley best_;
    SweepStatus ended_ = SweepStatus::proved;
    std::array<Sector, capacity> sectors_;
    std::size_t count_ = 0;
};

} // namespace chesil
