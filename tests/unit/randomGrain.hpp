#pragma once

#include "core/base/pose.hpp"
#include "core/shapes/convexPolygon.hpp"
#include "core/shapes/polyBezier.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

/// Random grains for tests: convex by construction, the same on every machine for the same seed.
namespace chesil::test
{

/// Uniform numbers from a seed; std::uniform_real_distribution is left alone, since its numbers differ
/// from one standard library to the next.
class RandomSource
{
public:
    explicit RandomSource(std::uint64_t seed) : bits_(seed) {}

    /// In [low, high).
    double uniform(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
    }

    /// In [low, high), evenly in the logarithm; 0 < low.
    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

    /// One of low, low + 1, ..., high.
    int integer(int low, int high) { return low + static_cast<int>(uniform(0, high - low + 1)); }

    Vector2 direction()
    {
        const double angle = uniform(0, 2 * M_PI);
        return Vector2(std::cos(angle), std::sin(angle));
    }

    /// A position within `reach` [m] of the origin in x and y, any angle in (-pi, pi).
    Pose<2> pose(double reach)
    {
        const double x = uniform(-reach, reach);
        const double y = uniform(-reach, reach);
        return {Vector2(x, y), Rotation<2>(uniform(-M_PI, M_PI))};
    }

private:
    std::mt19937_64 bits_;
};

/// What a random polybezier grain is like.
struct RandomGrainOptions
{
    /// All segments, straight ones included. The curved rest must be at least 3, and as many as the straight
    /// and nearly straight ones together; else std::invalid_argument.
    int segments = 10;
    /// Segments that are exactly straight, and those that turn by 1e-8..1e-3 rad only.
    int straight = 0;
    int nearlyStraight = 0;
    /// Mean radius before straight segments lengthen the grain [m].
    double radius = 1;
    /// 0: a circle's joints; towards 1: the radius of curvature at the joints falls towards 0 somewhere.
    double waviness = 0.7;
};

/// A wavy convex body given by its support function h(a) = 1 + sum of c_k cos(k a + phase_k), k = 2..5,
/// widened by straight edges. Its radius of curvature is h + h'' >= 1 - sum of c_k (k^2 - 1), which the
/// constructor keeps above 1 - waviness. The Minkowski sum with a segment (an edge) keeps it convex.
class WavyBody
{
public:
    WavyBody(double waviness, RandomSource& random)
    {
        double sum = 0;
        for (Wave& wave : waves_)
        {
            wave.share = random.uniform(0, 1);
            wave.phase = random.uniform(0, 2 * M_PI);
            sum += wave.share;
        }
        for (Wave& wave : waves_)
        {
            wave.share *= waviness / sum;
        }
    }

    /// Adds a straight edge with this outward normal's angle [rad] and length.
    void addEdge(double normalAngle, double length) { edges_.push_back({normalAngle, length}); }

    /// The boundary point whose outward normal has this angle, in the interior of no edge's range:
    /// `side` < 0 gives the start, > 0 the end of an edge with just this normal.
    Vector2 point(double normalAngle, int side) const
    {
        const Vector2 normal(std::cos(normalAngle), std::sin(normalAngle));
        double height = 1;
        double slope = 0;
        int k = 2;
        for (const Wave& wave : waves_)
        {
            const double size = wave.share / (k * k - 1);
            height += size * std::cos(k * normalAngle + wave.phase);
            slope -= k * size * std::sin(k * normalAngle + wave.phase);
            ++k;
        }
        Vector2 result = height * normal + slope * perpendicular(normal);
        for (const Edge& edge : edges_)
        {
            const bool same = normalAngle == edge.normalAngle;
            if (same ? side > 0 : std::sin(normalAngle - edge.normalAngle) > 0)
            {
                result += edge.length * Vector2(-std::sin(edge.normalAngle), std::cos(edge.normalAngle));
            }
        }
        return result;
    }

private:
    struct Wave
    {
        double share = 0;
        double phase = 0;
    };
    struct Edge
    {
        double normalAngle = 0;
        double length = 0;
    };
    Wave waves_[4];
    std::vector<Edge> edges_;
};

/// `count` >= 3 rising angles in [0, 2 pi) whose gaps all lie between 0.2 of the mean one and 150 degrees.
inline std::vector<double> randomNormalAngles(int count, RandomSource& random)
{
    for (;;)
    {
        std::vector<double> gaps;
        double sum = 0;
        for (int i = 0; i < count; ++i)
        {
            gaps.push_back(random.uniform(0.25, 1.25));
            sum += gaps.back();
        }
        std::vector<double> angles{0};
        double largest = 0;
        for (const double gap : gaps)
        {
            largest = std::max(largest, gap * 2 * M_PI / sum);
            angles.push_back(angles.back() + gap * 2 * M_PI / sum);
        }
        angles.pop_back();
        if (largest < 150 * M_PI / 180)
        {
            return angles;
        }
    }
}

/// The segment between two boundary points of a convex body whose outward normals have these angles. Its
/// control edges lie on the tangents (G1 at the joints) and reach `share0`, `share1` in (0, 1] of the way
/// to their crossing, which makes the control polygon convex.
inline CubicBezier tangentSegment(const Vector2& start, double startNormal, const Vector2& end,
                                  double endNormal, double share0, double share1)
{
    if (startNormal == endNormal)
    {
        return CubicBezier::straight(start, end);
    }
    const Vector2 tangent0(-std::sin(startNormal), std::cos(startNormal));
    const Vector2 tangent1(-std::sin(endNormal), std::cos(endNormal));
    const double turn = std::sin(endNormal - startNormal);
    const Vector2 chord = end - start;
    const double reach0 = cross(chord, tangent1) / turn;
    const double reach1 = cross(tangent0, chord) / turn;
    return CubicBezier({start, start + share0 * reach0 * tangent0, end - share1 * reach1 * tangent1, end});
}

/// The boundary of a random convex grain with one tangent at every joint (G1): joints are boundary points
/// of a WavyBody, segments run along its tangents. Roughly centred on the origin [m].
inline std::vector<CubicBezier> randomSegments(const RandomGrainOptions& options, RandomSource& random)
{
    const int edges = options.straight + options.nearlyStraight;
    const int curved = options.segments - edges;
    if (curved < 3 || edges > curved)
    {
        throw std::invalid_argument("RandomGrainOptions: too few curved segments");
    }
    const std::vector<double> angles = randomNormalAngles(curved, random);
    WavyBody body(options.waviness, random);

    struct Joint
    {
        double normal;
        int side;
    };
    std::vector<Joint> joints;
    const int first = random.integer(0, curved - 1);
    for (int i = 0; i < curved; ++i)
    {
        // Edges are dealt to the joints from a random one on, the straight ones first.
        const int rank = (i - first + curved) % curved;
        double turn = 0;
        if (rank >= edges)
        {
            joints.push_back({angles[i], 0});
            continue;
        }
        body.addEdge(angles[i], random.uniform(0.1, 0.8));
        if (rank >= options.straight)
        {
            turn = random.logUniform(1e-8, 1e-3);
        }
        joints.push_back({angles[i] - turn / 2, -1});
        joints.push_back({angles[i] + turn / 2, 1});
    }

    std::vector<Vector2> points;
    for (const Joint& joint : joints)
    {
        points.push_back(options.radius * body.point(joint.normal, joint.side));
    }
    std::vector<CubicBezier> segments;
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        const std::size_t next = (i + 1) % joints.size();
        const double share0 = random.uniform(0.3, 0.8);
        const double share1 = random.uniform(0.3, 0.8);
        segments.push_back(
            tangentSegment(points[i], joints[i].normal, points[next], joints[next].normal, share0, share1));
    }
    return segments;
}

inline PolyBezier randomPolyBezier(const RandomGrainOptions& options, RandomSource& random)
{
    return PolyBezier(randomSegments(options, random));
}

/// A polygon with its vertices at support points of a wavy body of mean radius `radius` [m].
inline ConvexPolygon randomPolygon(int sides, double radius, RandomSource& random)
{
    const std::vector<double> angles = randomNormalAngles(sides, random);
    const WavyBody body(0.7, random);
    std::vector<Vector2> vertices;
    for (const double angle : angles)
    {
        vertices.push_back(radius * body.point(angle, 0));
    }
    return ConvexPolygon(vertices);
}

} // namespace chesil::test
