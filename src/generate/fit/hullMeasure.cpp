#include "generate/fit/hullMeasure.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

namespace
{

/// Cells of the measure for each segment, and the reach of the smoothing in cells.
constexpr int cellsPerSegment = 24;
constexpr int smoothing = 8;

/// Share of length and turn in the measure.
constexpr double evenShare = 0.1;

/// Share of an even turn in the angles, so that they rise along straight sides, too.
constexpr double evenTurn = 0.01;

/// Length and turn run through along a piece: at the ends of its edges, and at both sides of its vertices.
struct Course
{
    std::vector<double> lengths{0};
    std::vector<double> angles;

    void addEdge(double length)
    {
        lengths.push_back(lengths.back() + length);
        angles.push_back(angles.back());
    }
    void addTurn(double turn)
    {
        lengths.push_back(lengths.back());
        angles.push_back(angles.back() + turn);
    }

    /// Value at `place` of the sequence that has `values` at `places`.
    static double at(const std::vector<double>& places, const std::vector<double>& values, double place)
    {
        const auto after = std::upper_bound(places.begin(), places.end(), place);
        if (after == places.begin())
        {
            return values.front();
        }
        if (after == places.end())
        {
            return values.back();
        }
        const auto i = static_cast<std::size_t>(after - places.begin());
        const double share = (place - places[i - 1]) / (places[i] - places[i - 1]);
        return values[i - 1] + share * (values[i] - values[i - 1]);
    }

    /// Mean direction of the outline between two lengths, given as its normal's angle.
    double meanAngle(double from, double to) const
    {
        double sum = 0;
        for (std::size_t i = 1; i < lengths.size(); ++i)
        {
            const double part = std::min(to, lengths[i]) - std::max(from, lengths[i - 1]);
            sum += std::max(0.0, part) * angles[i];
        }
        return sum / (to - from);
    }
};

Course courseOf(const std::vector<Vector2>& polygon, std::size_t first, std::size_t last, double startAngle)
{
    Course course;
    course.angles.push_back(startAngle);
    const auto edge = [&](std::size_t i)
    { return Vector2(polygon[(i + 1) % polygon.size()] - polygon[i % polygon.size()]); };
    for (std::size_t i = first; i < last; ++i)
    {
        course.addEdge(edge(i).norm());
        if (i + 1 < last)
        {
            course.addTurn(std::atan2(cross(edge(i), edge(i + 1)), edge(i).dot(edge(i + 1))));
        }
    }
    return course;
}

double normalAngle(const Vector2& edge) { return std::atan2(-edge.x(), edge.y()); }

/// Means over `smoothing` cells on both sides, over fewer near the ends unless the values go on round the
/// outline, rising by `period`.
std::vector<double> smoothed(const std::vector<double>& values, bool closed)
{
    const int cells = static_cast<int>(values.size()) - 1;
    const double period = values.back() - values.front();
    const auto value = [&](int i)
    {
        const int wrapped = (i % cells + cells) % cells;
        return i >= 0 && i <= cells
                   ? values[static_cast<std::size_t>(i)]
                   : values[static_cast<std::size_t>(wrapped)] + period * ((i - wrapped) / cells);
    };
    std::vector<double> means;
    for (int i = 0; i <= cells; ++i)
    {
        const int reach = closed ? smoothing : std::min({smoothing, i, cells - i});
        double sum = 0;
        for (int k = i - reach; k <= i + reach; ++k)
        {
            sum += value(k);
        }
        means.push_back(sum / (2 * reach + 1));
    }
    return means;
}

HullMeasure::Piece measured(const Course& course, double perimeter, int segments, bool closed)
{
    std::vector<double> places;
    for (std::size_t i = 0; i < course.lengths.size(); ++i)
    {
        places.push_back(course.lengths[i] / perimeter +
                         (course.angles[i] - course.angles.front()) / (2 * M_PI));
    }
    const double whole = places.back();
    const int cells =
        std::max(2 * smoothing, static_cast<int>(std::ceil(whole / 2 * segments * cellsPerSegment)));
    std::vector<double> lengths;
    std::vector<double> angles;
    for (int i = 0; i <= cells; ++i)
    {
        const double place = whole * i / cells;
        lengths.push_back(Course::at(places, course.lengths, place));
        angles.push_back(Course::at(places, course.angles, place));
    }
    lengths = smoothed(lengths, closed);
    angles = smoothed(angles, closed);

    HullMeasure::Piece piece;
    piece.measures.push_back(0);
    const double turn = angles.back() - angles.front();
    for (int i = 0; i <= cells; ++i)
    {
        const auto k = static_cast<std::size_t>(i);
        piece.angles.push_back((1 - evenTurn) * angles[k] + evenTurn * (angles[0] + turn * i / cells));
        if (i > 0)
        {
            const double length = (lengths[k] - lengths[k - 1]) / perimeter;
            const double bend = (angles[k] - angles[k - 1]) / (2 * M_PI);
            piece.measures.push_back(piece.measures.back() + std::cbrt(length * length * bend) +
                                     evenShare * (length + bend) / 2);
        }
    }
    return piece;
}

/// The mean angles of the first two stretches, extrapolated to the end.
void extrapolate(HullMeasure::Piece& piece, const Course& course, double perimeter)
{
    const double whole = course.lengths.back();
    const double stretch = std::min(0.04 * perimeter, whole / 4);
    const auto mean = [&](double from) { return course.meanAngle(from, from + stretch); };
    piece.startAngle = 1.5 * mean(0) - 0.5 * mean(stretch);
    piece.endAngle = 1.5 * mean(whole - stretch) - 0.5 * mean(whole - 2 * stretch);
}

bool isStraight(const std::vector<Vector2>& polygon, const HullCorner& from, const HullCorner& to,
                std::size_t last, double allowed)
{
    const Vector2 normal = -perpendicular(Vector2(to.position - from.position)).normalized();
    for (std::size_t i = from.last + 1; i < last; ++i)
    {
        if (normal.dot(polygon[i % polygon.size()] - from.position) > allowed)
        {
            return false;
        }
    }
    return true;
}

/// The first vertex of the corner after corner k, counted on from that.
std::size_t nextFirst(const std::vector<HullCorner>& corners, std::size_t k, std::size_t count)
{
    return k + 1 < corners.size() ? corners[k + 1].first : corners.front().first + count;
}

} // namespace

HullMeasure::HullMeasure(const std::vector<Vector2>& polygon, const std::vector<HullCorner>& corners,
                         int segments)
{
    double perimeter = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
        perimeter += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
    }
    const auto edgeAngle = [&](std::size_t i)
    { return normalAngle(polygon[(i + 1) % polygon.size()] - polygon[i % polygon.size()]); };
    if (corners.empty())
    {
        Course course = courseOf(polygon, 0, polygon.size(), edgeAngle(0));
        course.addTurn(edgeAngle(0) + 2 * M_PI - course.angles.back());
        pieces_.push_back(measured(course, perimeter, segments, true));
    }
    double angle = corners.empty() ? 0 : edgeAngle(corners.front().last);
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
        // One turn at most from one piece to the next
        angle += std::remainder(edgeAngle(corners[k].last) - angle, 2 * M_PI);
        const Course course =
            courseOf(polygon, corners[k].last, nextFirst(corners, k, polygon.size()), angle);
        pieces_.push_back(measured(course, perimeter, segments, false));
        extrapolate(pieces_.back(), course, perimeter);
        angle = course.angles.back() + corners[(k + 1) % corners.size()].turn;
    }
}

void HullMeasure::findStraightPieces(const std::vector<Vector2>& polygon,
                                     const std::vector<HullCorner>& corners, double pixel)
{
    constexpr double allowed = 0.75;
    for (std::size_t k = 0; k < corners.size() && corners.size() > 1; ++k)
    {
        pieces_[k].straight = isStraight(polygon, corners[k], corners[(k + 1) % corners.size()],
                                         nextFirst(corners, k, polygon.size()), allowed * pixel);
    }
}

double HullMeasure::Piece::angleAt(double measure) const { return Course::at(measures, angles, measure); }

} // namespace chesil
