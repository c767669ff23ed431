#include "core/measure/enclosedArea.hpp"

#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace chesil;

namespace
{

using HalfPlanes = std::vector<std::pair<Vector2, Vector2>>;

HalfPlanes boxOf(double width, double height)
{
    return {{Vector2(0, 0), Vector2(0, 1)}, {Vector2(0, 0), Vector2(1, 0)}, {Vector2(width, 5), Vector2(-1, 0)}, {Vector2(7, height), Vector2(0, -1)}};
}

} // namespace

TEST(EnclosedArea, ofBoxesAndPolygons)
{
    EXPECT_NEAR(*enclosedArea(boxOf(2, 3)), 6, 1e-14);
    // Regular polygons about their inscribed circle, moved and turned.
    test::RandomSource random(17);
    for (int sides = 3; sides < 12; ++sides)
    {
        const Vector2 centre = 10 * random.direction();
        const double turned = random.uniform(0, 6);
        HalfPlanes planes;
        for (int k = 0; k < sides; ++k)
        {
            const double angle = turned + 2 * M_PI * k / sides;
            const Vector2 outward(std::cos(angle), std::sin(angle));
            planes.push_back({centre + outward, -outward});
        }
        EXPECT_NEAR(*enclosedArea(planes), sides * std::tan(M_PI / sides), 1e-12) << sides;
    }
}

TEST(EnclosedArea, wallsThatDoNotBoundChangeNothing)
{
    HalfPlanes planes = boxOf(1, 1);
    planes.push_back({Vector2(0, -1), Vector2(0, 1)});
    planes.push_back({Vector2(0, 0), Vector2(0, 1)});
    planes.push_back({Vector2(-3, -3), Vector2(1, 1).normalized()});
    EXPECT_NEAR(*enclosedArea(planes), 1, 1e-14);
}

TEST(EnclosedArea, openOrEmptyIsNone)
{
    EXPECT_FALSE(enclosedArea({}));
    HalfPlanes open = boxOf(1, 1);
    open.pop_back();
    EXPECT_FALSE(enclosedArea(open));
    EXPECT_FALSE(enclosedArea({{Vector2(0, 0), Vector2(0, 1)}, {Vector2(0, 1), Vector2(0, -1)}}));
    HalfPlanes empty = boxOf(1, 1);
    empty.push_back({Vector2(0, 2), Vector2(0, 1)});
    EXPECT_FALSE(enclosedArea(empty));
}
