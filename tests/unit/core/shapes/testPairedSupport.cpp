#include "core/shapes/polyBezier.hpp"

#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Two grains side by side give the bits that each gives alone.

using namespace chesil;

namespace
{

void expectSame(const CurvedPoint<2>& alone, const CurvedCoordinates<TwoLanes>& paired, int lane)
{
    EXPECT_EQ(alone.point.x(), paired.x[lane]);
    EXPECT_EQ(alone.point.y(), paired.y[lane]);
    EXPECT_EQ(alone.radius.value, paired.radius[lane]);
    EXPECT_EQ(alone.radius.first, paired.radiusFirst[lane]);
    EXPECT_EQ(alone.radius.second, paired.radiusSecond[lane]);
    EXPECT_EQ(alone.room, paired.room[lane]);
}

} // namespace

TEST(PairedSupport, hasTheBitsOfEachGrainAlone)
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
            const auto paired = PolyBezier::curvedSupports(
                a, b, TwoLanes{normalA.x(), normalB.x()}, TwoLanes{normalA.y(), normalB.y()});
            expectSame(a.curvedSupport(normalA), paired, 0);
            expectSame(b.curvedSupport(normalB), paired, 1);
        }
    }
}
