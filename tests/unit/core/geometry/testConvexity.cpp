#include "core/geometry/convexity.hpp"

#include "core/base/setupError.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace chesil;
using testing::HasSubstr;

namespace
{

std::string refusal(const std::vector<Vector2>& vertices)
{
    try
    {
        requireConvex(vertices);
    }
    catch (const ValueError& error)
    {
        EXPECT_THAT(error.expected(), HasSubstr("convex"));
        return error.found();
    }
    ADD_FAILURE() << "not refused";
    return "";
}

const std::vector<Vector2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

} // namespace

TEST(Convexity, acceptsConvexOutlines)
{
    EXPECT_NO_THROW(requireConvex(square));
    EXPECT_NO_THROW(requireConvex({{0, 0}, {1, 0}, {0, 1e-6}}));
    EXPECT_NO_THROW(requireConvex({{0, 0}, {0.5, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}));
    // Inward by less than the tolerance of 1e-9 rad.
    EXPECT_NO_THROW(requireConvex({{0, 0}, {0.5, 1e-10}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST(Convexity, refusesWhatIsNotFinite)
{
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
        std::vector<Vector2> vertices = square;
        vertices[2].y() = bad;
        EXPECT_THAT(refusal(vertices), HasSubstr("not a number at vertex 2"));
    }
}

TEST(Convexity, refusesFewerThanThreeVertices)
{
    EXPECT_THAT(refusal({}), HasSubstr("fewer than three"));
    EXPECT_THAT(refusal({{0, 0}, {1, 0}}), HasSubstr("fewer than three"));
    EXPECT_THAT(refusal({{0, 0}, {1, 0}, {1, 0}, {0, 0}}), HasSubstr("fewer than three"));
}

TEST(Convexity, refusesClockwise)
{
    std::vector<Vector2> vertices = square;
    std::reverse(vertices.begin(), vertices.end());
    EXPECT_THAT(refusal(vertices), HasSubstr("inward turn of 1.5708 rad"));
}

TEST(Convexity, refusesADentAndNamesTheVertex)
{
    EXPECT_THAT(refusal({{0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}}), HasSubstr("at vertex 2 (1 0.5)"));
    EXPECT_THAT(refusal({{0, 0}, {0.5, 1e-8}, {1, 0}, {1, 1}, {0, 1}}), HasSubstr("at vertex 1"));
}

TEST(Convexity, refusesCrossingItself)
{
    EXPECT_THAT(refusal({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), HasSubstr("inward turn"));
    // The five-pointed star turns left everywhere, but twice around.
    std::vector<Vector2> star;
    for (int i = 0; i < 5; ++i)
    {
        star.emplace_back(std::cos(4 * M_PI * i / 5), std::sin(4 * M_PI * i / 5));
    }
    EXPECT_THAT(refusal(star), HasSubstr("2 full turns"));
}

TEST(Convexity, refusesAFlatOutline)
{
    // No area to speak of: all on a line, in whatever direction and order.
    for (const Vector2& along : {Vector2(1, 0), Vector2(0, 1), Vector2(1, 1), Vector2(-1, 1), Vector2(3, 7)})
    {
        EXPECT_THAT(refusal({Vector2::Zero(), along, 2 * along}), testing::Not(""));
        EXPECT_THAT(refusal({2 * along, along, Vector2::Zero()}), testing::Not(""));
        EXPECT_THAT(refusal({Vector2::Zero(), along, 3 * along, 2 * along}), testing::Not(""));
    }
}
