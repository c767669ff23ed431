#include "generate/fit/hullCorners.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace chesil
{

namespace
{

constexpr double leastTurn = 45 * M_PI / 180;
constexpr double mostTurn = 140 * M_PI / 180;
constexpr double cornerPixels = 3;
constexpr double leastPerimeter = 200;
constexpr double besidePixels = 9;
constexpr double shareOfTurn = 0.85;

/// A polygon's lengths and turns.
struct Turns
{
    explicit Turns(const std::vector<Vector2>& polygon)
    {
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
            const Vector2 before = polygon[i] - polygon[(i + polygon.size() - 1) % polygon.size()];
            const Vector2 after = polygon[(i + 1) % polygon.size()] - polygon[i];
            lengths.push_back(after.norm());
            turns.push_back(std::atan2(cross(before, after), before.dot(after)));
        }
    }

    std::size_t size() const { return turns.size(); }
    double length(std::size_t i) const { return lengths[i % size()]; }
    double turn(std::size_t i) const { return turns[i % size()]; }
    double perimeter() const { return std::accumulate(lengths.begin(), lengths.end(), 0.0); }

    /// Of the vertices further on than `last` that are not further away than `reach`.
    double turnAfter(std::size_t last, double reach) const
    {
        double sum = 0;
        double way = length(last);
        for (std::size_t i = last + 1; way <= reach && i < last + size(); ++i)
        {
            sum += turn(i);
            way += length(i);
        }
        return sum;
    }

    double turnBefore(std::size_t first, double reach) const
    {
        double sum = 0;
        std::size_t i = first + size() - 1;
        for (double way = length(i); way <= reach && i > first; way += length(i))
        {
            sum += turn(i);
            --i;
        }
        return sum;
    }

    std::vector<double> lengths;
    std::vector<double> turns;
};

/// Where the sides before and after the vertices meet.
Vector2 cornerPosition(const std::vector<Vector2>& polygon, std::size_t first, std::size_t last)
{
    const std::size_t count = polygon.size();
    const Vector2& start = polygon[first % count];
    const Vector2& end = polygon[last % count];
    const Vector2 before = start - polygon[(first + count - 1) % count];
    const Vector2 after = polygon[(last + 1) % count] - end;
    const double sine = cross(before, after);
    const Vector2 middle = (start + end) / 2;
    if (first == last || !(sine > 0.1 * before.norm() * after.norm()))
    {
        return middle;
    }
    return start + cross(end - start, after) / sine * before;
}

/// The vertices from `first` on that turn within this length.
HullCorner cornerFrom(std::size_t first, const Turns& turns, double length)
{
    HullCorner corner{Vector2::Zero(), first, first, turns.turn(first)};
    double way = turns.length(first);
    while (way <= length && corner.last + 1 < first + turns.size())
    {
        ++corner.last;
        corner.turn += turns.turn(corner.last);
        way += turns.length(corner.last);
    }
    return corner;
}

bool isSharp(const HullCorner& corner, const Turns& turns, double pixel)
{
    const double beside = turns.turnBefore(corner.first, besidePixels * pixel) +
                          turns.turnAfter(corner.last, besidePixels * pixel);
    return corner.turn >= leastTurn && corner.turn <= mostTurn &&
           corner.turn >= shareOfTurn * (corner.turn + beside);
}

bool overlap(const HullCorner& a, const HullCorner& b, std::size_t count)
{
    const auto within = [&](std::size_t vertex, const HullCorner& corner)
    { return (vertex + count - corner.first) % count <= corner.last - corner.first; };
    return within(a.first % count, b) || within(b.first % count, a);
}

} // namespace

std::vector<HullCorner> hullCorners(const std::vector<Vector2>& polygon, double pixel)
{
    std::vector<HullCorner> candidates;
    const Turns turns(polygon);
    const bool resolved = pixel > 0 && turns.perimeter() >= leastPerimeter * pixel;
    for (std::size_t first = 0; first < polygon.size() && resolved; ++first)
    {
        const HullCorner corner = cornerFrom(first, turns, cornerPixels * pixel);
        if (isSharp(corner, turns, pixel))
        {
            candidates.push_back(corner);
        }
    }
    // Of equally sharp ones, to rounding, the shorter
    const auto rank = [](const HullCorner& corner)
    { return corner.turn - 1e-6 * static_cast<double>(corner.last - corner.first); };
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](const HullCorner& a, const HullCorner& b) { return rank(a) > rank(b); });
    std::vector<HullCorner> corners;
    for (HullCorner& candidate : candidates)
    {
        if (std::none_of(corners.begin(), corners.end(),
                         [&](const HullCorner& other) { return overlap(candidate, other, polygon.size()); }))
        {
            candidate.position = cornerPosition(polygon, candidate.first, candidate.last);
            corners.push_back(candidate);
        }
    }
    std::sort(corners.begin(), corners.end(),
              [](const HullCorner& a, const HullCorner& b) { return a.first < b.first; });
    return corners;
}

} // namespace chesil
