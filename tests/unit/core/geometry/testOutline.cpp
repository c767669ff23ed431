#include "core/geometry/outline.hpp"

#include "unit/knownShapes.hpp"
#include "unit/preciseCurve.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace chesil;

namespace
{

/// Largest distance of the outline (a dense sweep) from the closed polygon of the points.
double largestGap(const Outline& outline, const std::vector<Vector2>& points)
{
    double largest = 0;
    for (const OutlinePiece& piece : outline)
    {
        constexpr int samples = 2000;
        for (int k = 0; k < samples; ++k)
        {
            const test::PrecisePoint p =
                std::visit([&](const auto& q) { return test::preciseAt(q, test::Real(k) / samples); }, piece);
            const Vector2 x(static_cast<double>(p.x), static_cast<double>(p.y));
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < points.size(); ++i)
            {
                const Vector2 edge = points[(i + 1) % points.size()] - points[i];
                const double share = std::clamp((x - points[i]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (x - points[i] - share * edge).norm());
            }
            largest = std::max(largest, nearest);
        }
    }
    return largest;
}

} // namespace

TEST(Outline, pointsLeaveTheCurveByLessThanTheTolerance)
{
    test::RandomSource random(31);
    const PolyBezier grain = test::randomPolyBezier({8, 1, 1}, random);
    const std::vector<Outline> outlines{
        grain.outline(), {EllipticArc{Vector2(1, 2), Vector2(0, 3), Vector2(-0.2, 0), 0, 2 * M_PI}}};
    for (const Outline& outline : outlines)
    {
        for (const double tolerance : {1e-1, 1e-2, 1e-3})
        {
            const std::vector<Vector2> points = outlinePoints(outline, tolerance);
            const double gap = largestGap(outline, points);
            EXPECT_LE(gap, tolerance);
            // The bound is not many times too fine (a factor of 2 in the count is one of 4 in the gap),
            // unless each piece is one chord already.
            if (points.size() > 4 * outline.size())
            {
                EXPECT_GE(gap, tolerance / 20) << points.size() << " points";
            }
        }
    }
}

TEST(Outline, fineTolerancesAreKept)
{
    // The sagitta of a circle's chord over the angle h is 1 - cos(h/2).
    const Outline circle{EllipticArc{Vector2::Zero(), Vector2(1, 0), Vector2(0, 1), 0, 2 * M_PI}};
    for (const double tolerance : {1e-4, 1e-6, 1e-8})
    {
        const auto count = static_cast<double>(outlinePoints(circle, tolerance).size());
        const double sagitta = 2 * std::pow(std::sin(M_PI / (2 * count)), 2);
        EXPECT_LE(sagitta, tolerance);
        EXPECT_GE(sagitta, tolerance / 2);
    }
}

TEST(Outline, pointsRunCounterClockwiseAndNoneIsRepeated)
{
    const Outline outline = test::roundedSquare(2, 0.3).outline();
    const std::vector<Vector2> points = outlinePoints(outline, 1e-3);
    double doubleArea = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Vector2& next = points[(i + 1) % points.size()];
        EXPECT_GT((next - points[i]).norm(), 1e-6);
        doubleArea += cross(points[i], next);
    }
    EXPECT_NEAR(doubleArea / 2, 4 - (4 - M_PI) * 0.3 * 0.3, 1e-2);
    // A straight side needs its two ends only: four sides and four corners of sqrt(0.3/(8e-3)) chords or
    // more.
    EXPECT_LT(points.size(), 4u * (1 + 2 * 12));
}

TEST(Outline, placedTurnsThenMoves)
{
    const Pose<2> pose{Vector2(3, 4), Rotation<2>(M_PI / 2)};
    const Outline outline{CubicBezier::straight({1, 0}, {2, 1}),
                          EllipticArc{Vector2(1, 0), Vector2(2, 0), Vector2(0, 1), 0, 1}};
    const Outline moved = placed(outline, pose);
    const auto& segment = std::get<CubicBezier>(moved[0]);
    EXPECT_LT((segment.start() - Vector2(3, 5)).norm(), 1e-15);
    EXPECT_LT((segment.end() - Vector2(2, 6)).norm(), 1e-15);
    const auto& arc = std::get<EllipticArc>(moved[1]);
    EXPECT_LT((arc.at(0) - Vector2(3, 7)).norm(), 1e-15);
    EXPECT_EQ(arc.to, 1);
}
