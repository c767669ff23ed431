#include "core/shapes/polyBezier.hpp"

#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Two grains side by side give what each gives alone, to rounding: where one of them meets a piece's end, the other may
// go another way through the same formula.

using namespace chesil;

namespace
{

void expectClose(double alone, double paired, double scale, const char* what)
{
    // Radii and their derivatives are quotients of differences: some hundred roundings.
    constexpr double rounding = 1e-12;
    EXPECT_TRUE(alone == paired || std::abs(alone - paired) <= rounding * (std::abs(alone) + scale))
        << what << ": alone " << alone << ", paired less that " << paired - alone;
}

void expectSame(const CurvedPoint<2>& alone, const CurvedCoordinates<TwoLanes>& paired, int lane)
{
    expectClose(alone.point.x(), paired.x[lane], 1, "x");
    expectClose(alone.point.y(), paired.y[lane], 1, "y");
    expectClose(alone.radius.value, paired.radius[lane], 1, "radius");
    // On a straight side they have no meaning.
    if (std::isfinite(alone.radius.value))
    {
        expectClose(alone.radius.first, paired.radiusFirst[lane], 1 + std::abs(alone.radius.value), "its first derivative");
        expectClose(alone.radius.second, paired.radiusSecond[lane], 1 + std::abs(alone.radius.first), "its second derivative");
    }
    expectClose(alone.room, paired.room[lane], 1, "room");
}

} // namespace

TEST(PairedSupport, isThatOfEachGrainAlone)
{
    constexpr std::uint64_t seed = 20261123;
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::RandomSource random(seed);
    for (int trial = 0; trial < 200; ++trial)
    {
        test::RandomGrainOptions smooth;
        smooth.segments = random.integer(3, 20);
        test::RandomGrainOptions flat;
        flat.segments = 10;
        flat.straight = random.integer(0, 3);
        flat.nearlyStraight = random.integer(0, 2);
        const PolyBezier a = test::randomPolyBezier(smooth, random);
        const PolyBezier b = test::randomPolyBezier(flat, random);
        for (int direction = 0; direction < 50; ++direction)
        {
            const double angle = random.uniform(0, 2 * M_PI);
            const double other = random.uniform(0, 2 * M_PI);
            // Every other time along the normal of a straight side, if there is one.
            const StraightSide* side = b.straightSideFacing(Vector2(std::cos(other), std::sin(other)));
            const Vector2 normalA(std::cos(angle), std::sin(angle));
            const Vector2 normalB = side && direction % 2 ? side->normal : Vector2(std::cos(other), std::sin(other));
            // A guess of other pieces, or of none, costs time only; the pieces found are the right ones.
            auto guess = PieceGuess::of(static_cast<std::size_t>(random.integer(0, 12)), static_cast<std::size_t>(random.integer(0, 300)));
            for (int attempt = 0; attempt < 2; ++attempt)
            {
                const auto paired = PolyBezier::curvedSupports(
                    a, b, TwoLanes{normalA.x(), normalB.x()}, TwoLanes{normalA.y(), normalB.y()}, guess);
                expectSame(a.curvedSupport(normalA), paired, 0);
                expectSame(b.curvedSupport(normalB), paired, 1);
            }
        }
    }
}
