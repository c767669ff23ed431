#pragma once

#include "unit/randomGrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace chesil::benchmark
{

/// A smooth irregular grain to approximate, and outlines of its after the rule of Lai & Huang, section 4:
/// joints (or vertices) at the support points of equally spaced normals.
class WavyReference
{
public:
    explicit WavyReference(test::RandomSource& random) : body_(waviness, random) {}

    Vector2 point(double angle) const { return body_.point(angle, 0); }

    /// Counter-clockwise.
    std::vector<Vector2> points(int count) const
    {
        std::vector<Vector2> result;
        for (int i = 0; i < count; ++i)
        {
            result.push_back(point(2 * M_PI * i / count));
        }
        return result;
    }

    /// The polygon of these points, enlarged about the origin to the grain's area.
    std::vector<Vector2> polygon(int sides) const
    {
        std::vector<Vector2> vertices = points(sides);
        const double scale = std::sqrt(area(points(dense)) / area(vertices));
        for (Vector2& vertex : vertices)
        {
            vertex *= scale;
        }
        return vertices;
    }

    /// Cubic segments between these points; of each, the lengths of the two control edges are fitted to the
    /// grain by least squares of the distance.
    std::vector<CubicBezier> segments(int count) const
    {
        std::vector<CubicBezier> result;
        for (int i = 0; i < count; ++i)
        {
            result.push_back(fittedSegment(2 * M_PI * i / count, 2 * M_PI * (i + 1) / count));
        }
        // Closed to the bit
        for (int i = 0; i < count; ++i)
        {
            auto points = result[static_cast<std::size_t>(i)].controlPoints();
            points[3] = result[static_cast<std::size_t>((i + 1) % count)].start();
            result[static_cast<std::size_t>(i)] = CubicBezier(points);
        }
        return result;
    }

    /// Area of the symmetric difference between the grain and the region inside the outline, over the grain's
    /// area. Both are seen from the origin, which lies in both.
    double difference(const std::vector<CubicBezier>& outline) const
    {
        const std::vector<Vector2> own = points(dense);
        double differing = 0;
        double whole = 0;
        for (std::size_t i = 0; i < own.size(); ++i)
        {
            const Vector2& before = own[(i + own.size() - 1) % own.size()];
            const Vector2& after = own[(i + 1) % own.size()];
            const double sector = cross(before, own[i]) + cross(own[i], after);
            const double reach = reachAlong(outline, own[i]);
            differing += sector * std::abs(1 - reach * reach);
            whole += sector;
        }
        return differing / whole;
    }

private:
    /// Radius of curvature >= 0.2 of the mean radius.
    static constexpr double waviness = 0.8;
    /// Points of the grain in integrals: ten for each side of the finest polygon.
    static constexpr int dense = 4096;

    static double area(const std::vector<Vector2>& vertices)
    {
        double sum = 0;
        for (std::size_t i = 0; i < vertices.size(); ++i)
        {
            sum += cross(vertices[i], vertices[(i + 1) % vertices.size()]);
        }
        return sum / 2;
    }

    /// Normal angle of the grain's point nearest to `position`, searched from `angle`.
    double nearestAngle(const Vector2& position, double angle) const
    {
        constexpr double step = 1e-4;
        for (int iteration = 0; iteration < 4; ++iteration)
        {
            const double radius = (point(angle + step) - point(angle - step)).norm() / (2 * step);
            const Vector2 normal(std::cos(angle), std::sin(angle));
            const Vector2 offset = position - point(angle);
            angle += offset.dot(perpendicular(normal)) / (radius + offset.dot(normal));
        }
        return angle;
    }

    /// Mean squared distance of a segment's points from the grain and its derivatives by the shares of both
    /// control edges, of which `arms` are the longest.
    struct Misfit
    {
        double value = 0;
        Vector2 slope = Vector2::Zero();
        Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    };

    Misfit misfit(const CubicBezier& segment, double from, double to,
                  const std::array<Vector2, 2>& arms) const
    {
        constexpr int samples = 24;
        Misfit result;
        for (int i = 0; i < samples; ++i)
        {
            const double t = (i + 0.5) / samples;
            const double angle = nearestAngle(segment.at(t), from + t * (to - from));
            const Vector2 normal(std::cos(angle), std::sin(angle));
            const double distance = (segment.at(t) - point(angle)).dot(normal);
            const Vector2 gradient =
                3 * (1 - t) * t * Vector2((1 - t) * normal.dot(arms[0]), t * normal.dot(arms[1]));
            result.value += distance * distance / samples;
            result.slope += distance * gradient / samples;
            result.squares += gradient * gradient.transpose() / samples;
        }
        return result;
    }

    /// Levenberg-Marquardt, since a longer first and a shorter second control edge nearly make up for each
    /// other.
    CubicBezier fittedSegment(double from, double to) const
    {
        constexpr int iterations = 60;
        const auto segment = [&](const Vector2& shares)
        { return test::tangentSegment(point(from), from, point(to), to, shares[0], shares[1]); };
        const std::array<Vector2, 4> longest = segment({1, 1}).controlPoints();
        const std::array<Vector2, 2> arms{longest[1] - longest[0], longest[2] - longest[3]};
        Vector2 shares(0.6, 0.6);
        Misfit best = misfit(segment(shares), from, to, arms);
        double damping = 1e-2;
        for (int iteration = 0; iteration < iterations; ++iteration)
        {
            const Eigen::Matrix2d m =
                best.squares + damping * best.squares.trace() * Eigen::Matrix2d::Identity();
            const Vector2 step = Vector2(m(1, 1) * best.slope[0] - m(0, 1) * best.slope[1],
                                         m(0, 0) * best.slope[1] - m(1, 0) * best.slope[0]) /
                                 (m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0));
            // Beyond 1 the control polygon would not be convex
            const Vector2 trial = (shares - step).cwiseMax(0.05).cwiseMin(1.0);
            const Misfit next = misfit(segment(trial), from, to, arms);
            damping *= next.value < best.value ? 0.2 : 5;
            if (next.value < best.value)
            {
                shares = trial;
                best = next;
            }
        }
        return segment(shares);
    }

    /// How many times the vector `ray` fits between the origin and the outline.
    static double reachAlong(const std::vector<CubicBezier>& outline, const Vector2& ray)
    {
        for (const CubicBezier& segment : outline)
        {
            // Counter-clockwise, each seen from the origin under less than 180 degrees
            if (cross(ray, segment.start()) <= 0 && cross(ray, segment.end()) > 0)
            {
                return segment.at(crossing(segment, ray)).dot(ray) / ray.squaredNorm();
            }
        }
        throw std::runtime_error("WavyReference: an outline that does not go round the origin");
    }

    /// The parameter at which a segment passes the ray, by Newton's rule kept between bounds.
    static double crossing(const CubicBezier& segment, const Vector2& ray)
    {
        double low = 0;
        double high = 1;
        double t = 0.5;
        for (int iteration = 0; iteration < 60; ++iteration)
        {
            const double side = cross(ray, segment.at(t));
            (side > 0 ? high : low) = t;
            double next = t - side / cross(ray, segment.derivative(t));
            if (!(next > low && next < high))
            {
                next = (low + high) / 2;
            }
            if (std::abs(next - t) < 1e-15)
            {
                break;
            }
            t = next;
        }
        return t;
    }

    test::WavyBody body_;
};

} // namespace chesil::benchmark
