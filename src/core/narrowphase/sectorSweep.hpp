#pragma once

#include "core/narrowphase/deepestValley.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace chesil
{

/// How a sweep ended.
enum class SweepStatus
{
    /// No direction in doubt is less deep than the valley returned.
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

/// The deepest valley by branch and bound over all directions in doubt. A sector between two normals whose support points are
/// known has a lower bound of the height: that of the two points themselves, each drawn in by the least radius of
/// curvature of the sector (doc/contactKernel.md, "All directions"). The sector with the lowest bound is split until
/// none is below the best valley. This is EPA with curvature.
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

    SweptValley run(const Doubt& doubt)
    {
        const Vector2 first = best_.normal;
        const bool cone = doubt.kind == Doubt::Kind::cone;
        const std::array<Vector2, 4> normals = cone
            ? std::array<Vector2, 4>{doubt.first, first, doubt.last, Vector2::Zero()}
            : std::array<Vector2, 4>{first, perpendicular(first), -first, -perpendicular(first)};
        const std::int32_t count = cone ? 3 : 4;
        for (std::int32_t i = 0; i < count; ++i)
        {
            if (!look(normals[index(i)]))
            {
                return {ended_, best_};
            }
        }
        for (std::int32_t i = 0; i + 1 < count; ++i)
        {
            push(boundedSector(i, i + 1));
        }
        if (!cone)
        {
            push(boundedSector(count - 1, 0));
        }
        while (sectors_[0].bound < best_.height - floor_)
        {
            if (rayCount_ == capacity)
            {
                return {SweepStatus::capacityReached, best_};
            }
            const Sector lowest = pop();
            const std::int32_t middle = rayCount_;
            if (!look(lowest.lowestNormal))
            {
                return {ended_, best_};
            }
            push(boundedSector(lowest.first, middle));
            push(boundedSector(middle, lowest.last));
        }
        return {SweepStatus::proved, best_};
    }

private:
    /// Deep pairs settle with some twenty rays; the least lucky of ten million, identical and nearly round, with half of
    /// this.
    static constexpr std::int32_t capacity = 2048;

    /// A normal and its support point.
    struct Ray
    {
        Vector2 normal;
        Vector2 vertex;
        double height;
    };

    /// Between two rays.
    struct Sector
    {
        double bound;
        /// Where the bound is, strictly inside; where to split.
        Vector2 lowestNormal;
        std::int32_t first;
        std::int32_t last;
    };

    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

    static bool isHigher(const Sector& a, const Sector& b) { return a.bound > b.bound; }

    void push(const Sector& sector)
    {
        sectors_[index(sectorCount_++)] = sector;
        std::push_heap(sectors_.begin(), sectors_.begin() + sectorCount_, isHigher);
    }

    Sector pop()
    {
        std::pop_heap(sectors_.begin(), sectors_.begin() + sectorCount_, isHigher);
        return sectors_[index(--sectorCount_)];
    }

    /// Asks for the support point along a normal and follows it down if it is the least height so far. False if that ends
    /// the sweep.
    bool look(const Vector2& normal)
    {
        const CurvedVertex<2> vertex = difference_.curvedSupport(normal);
        const double height = normal.dot(vertex.difference);
        if (!std::isfinite(height))
        {
            ended_ = SweepStatus::notFinite;
            return false;
        }
        rays_[index(rayCount_++)] = {normal, vertex.difference, height};
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

    /// The lowest value of the larger of n.p and n.q over the sector, p and q being the two points drawn in.
    Sector boundedSector(std::int32_t from, std::int32_t to) const
    {
        const Ray& first = rays_[index(from)];
        const Ray& last = rays_[index(to)];
        // No larger than the shapes, so that drawing a point in costs no digits.
        const double radius = std::min(difference_.leastRadiusBetween(first.normal, last.normal), difference_.size());
        const Vector2 p = first.vertex - radius * first.normal;
        const Vector2 q = last.vertex - radius * last.normal;
        Sector sector{std::min(first.height, last.height), unit(first.normal + last.normal), from, to};
        const auto tryNormal = [&](const Vector2& direction)
        {
            if (!(cross(first.normal, direction) > 0) || !(cross(direction, last.normal) > 0))
            {
                return;
            }
            const Vector2 normal = unit(direction);
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
    std::array<Ray, capacity> rays_;
    std::int32_t rayCount_ = 0;
    /// A heap, the lowest bound first. As many as rays.
    std::array<Sector, capacity> sectors_;
    std::int32_t sectorCount_ = 0;
};

} // namespace chesil
