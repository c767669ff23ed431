#include "core/narrowphase/searchStart.hpp"

#include "core/base/tolerances.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

Vector2 normalAt(double angle) { return {std::cos(angle), std::sin(angle)}; }

} // namespace

TEST(SearchStart, turnsByTheAngle)
{
    for (const double angle : {-smallTurn, -1e-3, -1e-9, 0.0, 1e-16, 1e-6, smallTurn})
    {
        EXPECT_LT((turnedBy(angle, normalAt(0.7)) - normalAt(0.7 + angle)).norm(), 2 * tolerances::epsilon) << angle;
    }
}

TEST(SearchStart, goesOnTurning)
{
    SearchStart start;
    EXPECT_EQ(start.expected(), Vector2::Zero());
    start.turnTo(normalAt(0.3));
    EXPECT_EQ(start.expected(), normalAt(0.3)) << "one normal tells no turn";
    start.turnTo(normalAt(0.301));
    EXPECT_LT((start.expected() - normalAt(0.302)).norm(), 1e-9);
    start.turnTo(normalAt(0.7));
    EXPECT_EQ(start.expected(), normalAt(0.7)) << "a jump is no turn";
    start.turnTo(normalAt(0.701));
    start.standAt(normalAt(0.7));
    EXPECT_EQ(start.expected(), normalAt(0.7));
    start.turnTo(-normalAt(0.7));
    EXPECT_EQ(start.expected(), -normalAt(0.7));
}

TEST(SearchStart, aNormalThatIsNoNumberTurnsNothing)
{
    SearchStart start{Vector2(std::nan(""), 0)};
    start.turnTo(normalAt(0.3));
    EXPECT_EQ(start.expected(), normalAt(0.3));
}
