#include "core/world/pairContact.hpp"

#include "unit/core/narrowphase/pairQuery.hpp"
#include "unit/core/world/worldScenes.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;

TEST(PairContact, disksByFormulaAreDisksByGjk)
{
    test::RandomSource random(181);
    int contacts = 0;
    for (int i = 0; i < 2000; ++i)
    {
        const Circle a(random.uniform(0.5, 1));
        const Circle b(random.uniform(0.5, 1));
        const Pose<2> poseA = random.pose(1);
        const Pose<2> poseB = random.pose(1);
        SearchStart start;
        ContactGeometry<2> contact{};
        const PairStatus status = pairContact(a, poseA, b, poseB, start, contact);
        const test::PairAnswer answer = test::query(a, poseA, b, poseB);
        ASSERT_EQ(status == PairStatus::overlapping, answer.overlaps());
        if (answer.overlaps())
        {
            ++contacts;
            const double depthError = answer.depthError;
            const double distance = (poseA.position - poseB.position).norm();
            EXPECT_NEAR(contact.depth, answer.depth, depthError);
            // The depth rises by distance (1 - cos) with the angle from the right normal.
            const double normalError = std::sqrt(2 * depthError / distance);
            EXPECT_LT((contact.normal - answer.normal).norm(), 1.01 * normalError);
            EXPECT_LT((contact.point - answer.point).norm(), 4 * normalError * answer.size);
        }
    }
    EXPECT_GT(contacts, 500);
}

TEST(PairContact, directionIsHandedOn)
{
    const Shape plate = Ellipse(2, 0.2);
    const Pose<2> here{};
    SearchStart start;
    ContactGeometry<2> contact{};
    // Apart, since their sum is the ellipse (4, 0.4); but not along the line of their centres.
    const Pose<2> apart{Vector2(3, 0.45), {}};
    const auto reach = [&](const Vector2& along)
    { return support(plate, along).dot(along) - (apart.position + support(plate, -along)).dot(along); };
    ASSERT_GT(reach(apart.position), 0);
    ASSERT_EQ(pairContact(plate, here, plate, apart, start, contact), PairStatus::separated);
    EXPECT_LT(reach(start.direction), 0) << "what is handed back separates them";
    const Pose<2> near{Vector2(2, 0.2), {}};
    ASSERT_EQ(pairContact(plate, here, plate, near, start, contact), PairStatus::overlapping);
    EXPECT_EQ(start.direction, contact.normal);
}

TEST(PairContact, farPairsAreNotSearched)
{
    const Shape egg = Ellipse(2, 1);
    SearchStart start;
    ContactGeometry<2> contact{};
    EXPECT_EQ(pairContact(egg, Pose<2>{}, egg, Pose<2>{Vector2(4.01, 0), {}}, start, contact),
              PairStatus::separated);
    EXPECT_EQ(start.direction, Vector2::Zero());
}

TEST(PairContact, notANumberHasAStatusForEveryPairOfKinds)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<NamedShape> shapes = test::shapesOfEachKind(182);
    for (const NamedShape& a : shapes)
    {
        for (const NamedShape& b : shapes)
        {
            SearchStart start;
            ContactGeometry<2> contact{};
            const Pose<2> broken{Vector2(0.01, nan), {}};
            EXPECT_EQ(pairContact(a.shape, Pose<2>{}, b.shape, broken, start, contact),
                      PairStatus::notFinite)
                << a.name << ' ' << b.name;
            start = {};
            const Pose<2> infinite{Vector2(INFINITY, 0), {}};
            EXPECT_EQ(pairContact(a.shape, Pose<2>{}, b.shape, infinite, start, contact),
                      PairStatus::notFinite)
                << a.name << ' ' << b.name;
        }
    }
}

TEST(PairContact, concentricDisksHaveAFiniteNormal)
{
    SearchStart start;
    ContactGeometry<2> contact{};
    ASSERT_EQ(pairContact(Circle(1), Pose<2>{}, Circle(0.5), Pose<2>{}, start, contact),
              PairStatus::overlapping);
    EXPECT_EQ(contact.depth, 1.5);
    EXPECT_EQ(contact.normal.norm(), 1);
}

TEST(PairContact, roundAndConcentricIsExact)
{
    // Every direction is as deep: EPA alone would fill its polytope.
    SearchStart start;
    ContactGeometry<2> contact{};
    const PairStatus status =
        pairContact(Ellipse(1, 1), Pose<2>{}, Ellipse(0.5, 0.5), Pose<2>{}, start, contact);
    ASSERT_EQ(status, PairStatus::overlapping);
    EXPECT_NEAR(contact.depth, 1.5, 1e-15);
}
