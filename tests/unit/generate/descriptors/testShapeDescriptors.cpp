#include "generate/descriptors/shapeDescriptors.hpp"

#include "generate/descriptors/fourierSpectrum.hpp"
#include "generate/descriptors/leastWidth.hpp"
#include "generate/image/convexHull.hpp"
#include "core/geometry/outline.hpp"
#include "unit/knownShapes.hpp"
#include "unit/randomGrain.hpp"
#include "unit/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

// Descriptors against formulas, and against slower computations of another kind.

using namespace chesil;

namespace
{

/// Of an outline r(theta), as a polygon of so many vertices.
template <class Radius>
ClosedOutline polar(const Radius& radius, int count)
{
    ClosedOutline points;
    for (int i = 0; i < count; ++i)
    {
        const double angle = 2 * M_PI * i / count;
        points.push_back(radius(angle) * Vector2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

ClosedOutline ofShape(const Shape& shape)
{
    return outlinePoints(outline(shape), 1e-7 * boundingRadius(shape));
}

/// Width 1: three arcs around the corners of an equilateral triangle.
ClosedOutline reuleaux()
{
    ClosedOutline points;
    constexpr int steps = 3000;
    for (int corner = 0; corner < 3; ++corner)
    {
        const double direction = 2 * M_PI * corner / 3;
        const Vector2 centre = Vector2(std::cos(direction), std::sin(direction)) / std::sqrt(3.0);
        for (int i = 0; i < steps; ++i)
        {
            const double angle = direction + M_PI * (5.0 / 6 + i / (3.0 * steps));
            points.push_back(centre + Vector2(std::cos(angle), std::sin(angle)));
        }
    }
    return points;
}

/// A square of side 2 with corners of this radius.
ClosedOutline roundedSquare(double radius)
{
    ClosedOutline points;
    constexpr int steps = 3000;
    for (int corner = 0; corner < 4; ++corner)
    {
        const double direction = M_PI_2 * corner;
        const Vector2 centre = Rotation<2>(direction).apply(Vector2(1 - radius, 1 - radius));
        for (int i = 0; i <= steps; ++i)
        {
            const double angle = direction + M_PI_2 * i / steps;
            points.push_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
        }
    }
    return points;
}

double cornerWeight(double curvature)
{
    return std::clamp((curvature - 1) / 0.4 + 0.5, 0.0, 1.0);
}

/// Of an ellipse with half-axes 1 and b, by its parameter.
double ellipseCornerRoundness(double b)
{
    constexpr int steps = 200000;
    double length = 0;
    double angle = 0;
    for (int i = 0; i < steps; ++i)
    {
        const double t = 2 * M_PI * (i + 0.5) / steps;
        const double speed = std::hypot(std::sin(t), b * std::cos(t));
        const double curvature = b / (speed * speed * speed);
        const double weight = cornerWeight(curvature * b);
        length += weight * speed;
        angle += weight * speed * curvature;
    }
    return length / angle / b;
}

struct Known
{
    std::string name;
    ShapeDescriptors found;
    double area;
    double perimeter;
    double elongation;
    double inscribed;
    double circumscribed;
    double cornerRoundness;
};

std::vector<Known> knownShapes()
{
    constexpr double b = 0.6;
    const double ellipsePerimeter = 4 * std::comp_ellint_2(std::sqrt(1 - b * b));
    const double corners = ellipseCornerRoundness(b);
    const Shape circle = Circle(1);
    const Shape ellipse = Ellipse(1, b);
    const ClosedOutline square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    // The arcs of a Reuleaux triangle have more than twice the radius of the inscribed circle: no corners.
    return {
        {"circle", describe(circle), M_PI, 2 * M_PI, 1, 1, 1, 1},
        {"outline of a circle", describe(ofShape(circle)), M_PI, 2 * M_PI, 1, 1, 1, 1},
        {"ellipse", describe(ellipse), M_PI * b, ellipsePerimeter, b, b, 1, corners},
        {"outline of an ellipse", describe(ofShape(ellipse)), M_PI * b, ellipsePerimeter, b, b, 1, corners},
        {"square", describe(test::rectangle(2, 2)), 4, 8, 1, 1, M_SQRT2, 0},
        {"outline of a square", describe(square), 4, 8, 1, 1, M_SQRT2, 0},
        {"Reuleaux triangle", describe(reuleaux()), (M_PI - std::sqrt(3.0)) / 2, M_PI, 1, 1 - 1 / std::sqrt(3.0), 1 / std::sqrt(3.0), 0},
        {"rounded square", describe(roundedSquare(0.3)), 4 - (4 - M_PI) * 0.09, 8 - (8 - 2 * M_PI) * 0.3, 1, 1, M_SQRT2 * 0.7 + 0.3, 0.3},
    };
}

double distanceTo(const ClosedOutline& outline, const Vector2& point)
{
    double nearest = 1e300;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Vector2& a = outline[i];
        const Vector2 edge = outline[(i + 1) % outline.size()] - a;
        const double along = std::clamp((point - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (a + along * edge - point).norm());
    }
    return nearest;
}

/// Largest distance from the edge on ever finer rasters around the best point; `inside(point)`.
template <class Inside>
double rasterInscribed(const ClosedOutline& outline, const Inside& inside)
{
    Vector2 best = Vector2::Zero();
    double largest = 0;
    const auto search = [&](double half, int steps)
    {
        const Vector2 middle = best;
        for (int i = -steps; i <= steps; ++i)
        {
            for (int j = -steps; j <= steps; ++j)
            {
                const Vector2 point = middle + half / steps * Vector2(i, j);
                const double distance = inside(point) ? distanceTo(outline, point) : 0;
                if (distance > largest)
                {
                    largest = distance;
                    best = point;
                }
            }
        }
    };
    search(1, 100);
    for (double half = 0.1; half > 1e-7; half /= 2)
    {
        search(half, 10);
    }
    return largest;
}

double bruteLeastWidth(const ClosedOutline& outline)
{
    double least = 1e300;
    for (int i = 0; i < 20000; ++i)
    {
        const double angle = M_PI * i / 20000;
        const Vector2 normal(std::cos(angle), std::sin(angle));
        double low = 1e300;
        double high = -1e300;
        for (const Vector2& point : outline)
        {
            low = std::min(low, point.dot(normal));
            high = std::max(high, point.dot(normal));
        }
        least = std::min(least, high - low);
    }
    return least;
}

/// The smallest circle rests on points that no half of it holds alone; returns by how much its radius misses them.
double missOfCircumscribed(const ClosedOutline& outline, const OutlineCircle& circle)
{
    double farthest = 0;
    std::vector<double> directions;
    for (const Vector2& point : outline)
    {
        const Vector2 way = point - circle.centre;
        farthest = std::max(farthest, way.norm());
        if (way.norm() > circle.radius * (1 - 1e-9))
        {
            directions.push_back(std::atan2(way.y(), way.x()));
        }
    }
    std::sort(directions.begin(), directions.end());
    double gap = directions.empty() ? 7 : directions.front() + 2 * M_PI - directions.back();
    for (std::size_t i = 1; i < directions.size(); ++i)
    {
        gap = std::max(gap, directions[i] - directions[i - 1]);
    }
    EXPECT_LE(gap, M_PI + 1e-6) << "it could be smaller";
    return std::abs(farthest - circle.radius);
}

} // namespace

TEST(ShapeDescriptors, areThoseOfFormulas)
{
    double worst = 0;
    for (const Known& shape : knownShapes())
    {
        SCOPED_TRACE(shape.name);
        const auto differs = [&](const char* what, double found, double expected)
        {
            const double off = std::abs(found - expected);
            // Chords leave a curve by 1e-7 of the radius; that of two opposite ones is in the width.
            EXPECT_LT(off, 1e-6) << what << ": " << found << ", expected " << expected;
            worst = std::max(worst, off);
        };
        const double equivalent = std::sqrt(4 * shape.area / M_PI);
        differs("area", shape.found.area / shape.area, 1);
        differs("perimeter", shape.found.perimeter / shape.perimeter, 1);
        differs("equivalent diameter", shape.found.equivalentDiameter / equivalent, 1);
        differs("inscribed", shape.found.inscribed.radius, shape.inscribed);
        differs("circumscribed", shape.found.circumscribed.radius, shape.circumscribed);
        differs("elongation", shape.found.elongation, shape.elongation);
        differs("circularity", shape.found.circularity, std::sqrt(shape.inscribed / shape.circumscribed));
        differs("sphericity", shape.found.sphericity, equivalent / (2 * shape.circumscribed));
        differs("convexity", shape.found.convexity, 1);
        EXPECT_EQ(shape.found.regularity, std::numeric_limits<double>::infinity());
        // A corner's one vertex has half of the two sides around it, up to 0.002 of the inscribed radius.
        EXPECT_NEAR(shape.found.cornerRoundness, shape.cornerRoundness, 2e-3);
    }
    test::record("grainsFromImages", "descriptorFormulaError", worst, "-");
}

TEST(ShapeDescriptors, ofRandomOutlinesAreThoseOfSlowerComputations)
{
    constexpr std::uint64_t seed = 20261125;
    test::RandomSource random(seed);
    double worst = 0;
    for (int i = 0; i < 10; ++i)
    {
        double amplitude[3];
        double phase[3];
        for (int n = 0; n < 3; ++n)
        {
            amplitude[n] = random.uniform(0.02, 0.12);
            phase[n] = random.uniform(0, 2 * M_PI);
        }
        const auto radius = [&](double angle)
        {
            double r = 1;
            for (int n = 0; n < 3; ++n)
            {
                r += amplitude[n] * std::cos((n + 2) * angle + phase[n]);
            }
            return r;
        };
        const ClosedOutline grain = polar(radius, 400);
        const ShapeDescriptors found = describe(grain);
        const auto inside = [&](const Vector2& p) { return p.norm() < 0.98 * radius(std::atan2(p.y(), p.x())); };
        const double inscribed = rasterInscribed(grain, inside);
        const double width = bruteLeastWidth(grain);
        const double offInscribed = std::abs(found.inscribed.radius - inscribed);
        const double offWidth = std::abs(leastWidth(convexHull(grain)).width - width);
        EXPECT_LT(offInscribed, 1e-6) << "seed " << seed << ", grain " << i;
        // The brute force's step is 1.6e-4 of an angle, over which a width of vertices changes by up to its length.
        EXPECT_LT(offWidth, 1e-3) << "seed " << seed << ", grain " << i;
        EXPECT_LT(missOfCircumscribed(grain, found.circumscribed), 1e-12) << "seed " << seed << ", grain " << i;
        EXPECT_LE(found.convexity, 1 + 1e-12);
        EXPECT_GE(found.inscribed.radius, inscribed - 1e-12);
        worst = std::max({worst, offInscribed, offWidth});
    }
    test::record("grainsFromImages", "descriptorIndependentError", worst, "-");
}

TEST(ShapeDescriptors, ofTemplatesDoNotKnowHowTheyLie)
{
    constexpr std::uint64_t seed = 20261126;
    test::RandomSource random(seed);
    double worst = 0;
    for (int i = 0; i < 12; ++i)
    {
        ClosedOutline points = ofShape(test::randomPolyBezier({}, random));
        const ShapeDescriptors one = describe(points);
        const Rotation<2> turn(random.uniform(0, 2 * M_PI));
        const double scale = std::exp(random.uniform(-9, 9));
        const Vector2 shift = 10 * scale * random.direction();
        for (Vector2& point : points)
        {
            point = scale * turn.apply(point) + shift;
        }
        const ShapeDescriptors other = describe(points);
        worst = std::max(
            {worst, std::abs(other.area / (scale * scale * one.area) - 1), std::abs(other.perimeter / (scale * one.perimeter) - 1),
             std::abs(other.inscribed.radius / (scale * one.inscribed.radius) - 1),
             std::abs(other.circumscribed.radius / (scale * one.circumscribed.radius) - 1),
             std::abs(other.elongation - one.elongation), std::abs(other.circularity - one.circularity),
             std::abs(other.sphericity - one.sphericity), std::abs(other.convexity - one.convexity),
             std::abs(other.roundness - one.roundness), std::abs(other.cornerRoundness - one.cornerRoundness)});
        ASSERT_TRUE(one.spectrum && other.spectrum);
        for (std::size_t n = 0; n < one.spectrum->size(); ++n)
        {
            worst = std::max(worst, std::abs((*one.spectrum)[n] - (*other.spectrum)[n]));
        }
        const double turned = std::remainder(other.elongationAngle - one.elongationAngle - turn.angle() * 180 / M_PI, 180);
        worst = std::max(worst, std::abs(turned) * M_PI / 180);
    }
    EXPECT_LT(worst, 1e-10) << "seed " << seed;
    test::record("grainsFromImages", "descriptorInvarianceTemplates", worst, "-");
}

TEST(ShapeDescriptors, aSpectrumHoldsTheWavesThatWereDrawn)
{
    for (const int n : {2, 3, 8, 40})
    {
        // An even number keeps the centroid; an odd one moves it by no more than its amplitude's square.
        const double amplitude = 1e-3;
        const auto spectrum =
            fourierSpectrum(polar([&](double angle) { return 1 + amplitude * std::cos(n * angle); }, 128 * 50), Vector2::UnitX());
        ASSERT_TRUE(spectrum);
        for (std::size_t k = 1; k < spectrum->size(); ++k)
        {
            EXPECT_NEAR((*spectrum)[k], static_cast<int>(k) == n ? amplitude : 0, 2e-6) << "n " << n << ", D_" << k;
        }
    }
}

TEST(ShapeDescriptors, aHookHasNoSpectrum)
{
    const ClosedOutline hook{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 3}, {3, 3}, {3, 1}, {0, 1}};
    const ShapeDescriptors found = describe(hook);
    EXPECT_FALSE(found.spectrum);
    EXPECT_DOUBLE_EQ(found.area, 10);
    EXPECT_NEAR(found.convexity, 10 / 16.0, 1e-12);
    // In a bend: from both outer sides as far as from the inner corner, sqrt(2) (1 - r) = r.
    EXPECT_NEAR(found.inscribed.radius, M_SQRT2 / (1 + M_SQRT2), 1e-12);
    EXPECT_GT(found.regularity, 0);
}
