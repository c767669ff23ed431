#include "core/measure/stress.hpp"

#include "unit/core/measure/contactScenes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace chesil;
using namespace chesil::test;

namespace
{

Eigen::Matrix2d stressOf(const ContactScene& scene)
{
    return meanStress(scene.contacts, scene.branch(), scene.area);
}

Eigen::Matrix2d rows(const Vector2& x, const Vector2& y)
{
    Eigen::Matrix2d tensor;
    tensor << x.transpose(), y.transpose();
    return tensor;
}

/// Normal and shear forces between grains 0, 1 and 2 and with wall 0 that are no lattice.
ContactScene randomScene(RandomSource& random)
{
    ContactScene scene;
    scene.grains = 20;
    scene.area = random.uniform(1, 2);
    for (int i = 0; i < 40; ++i)
    {
        const Vector2 branch = random.uniform(0.5, 2) * random.direction();
        const int second = i % 5 == 0 ? -1 : random.integer(10, 19);
        scene.add(random.integer(0, 9), second, branch, random.uniform(1, 3) * branch + random.direction());
    }
    return scene;
}

} // namespace

TEST(Stress, squareLatticeUnderBiaxialForces)
{
    const Eigen::Matrix2d stress = stressOf(squareLattice(4, 8, 0.5, Vector2(6, 0), Vector2(0, 2)));
    EXPECT_EQ(stress, rows(Vector2(12, 0), Vector2(0, 4)));
    const StressMeasures measures = stressMeasures(stress);
    EXPECT_EQ(measures.mean, 8);
    EXPECT_EQ(measures.deviatoric, 4);
    EXPECT_EQ(measures.major, 12);
    EXPECT_EQ(measures.minor, 4);
    EXPECT_EQ(measures.direction, 0.0);
    EXPECT_DOUBLE_EQ(measures.mobilisedFriction.value(), M_PI / 6);
}

TEST(Stress, shearForcesInBalance)
{
    const Eigen::Matrix2d stress = stressOf(squareLattice(4, 4, 0.5, Vector2(4, 1), Vector2(1, 4)));
    EXPECT_EQ(stress, rows(Vector2(8, 2), Vector2(2, 8)));
    const StressMeasures measures = stressMeasures(stress);
    EXPECT_EQ(measures.major, 10);
    EXPECT_EQ(measures.minor, 6);
    EXPECT_DOUBLE_EQ(measures.direction.value(), M_PI / 4);
}

/// Branch by row, force by column: a torque on the grains shows, and only in the antisymmetric part.
TEST(Stress, unbalancedTorquesAreNotSymmetric)
{
    const Eigen::Matrix2d stress = stressOf(squareLattice(4, 4, 0.5, Vector2(4, 1), Vector2(-1, 4)));
    EXPECT_EQ(stress, rows(Vector2(8, 2), Vector2(-2, 8)));
    EXPECT_EQ(stressMeasures(stress).deviatoric, 0);
}

TEST(Stress, twoDiskChain)
{
    Bodies<2> bodies;
    bodies.pose = {{Vector2(0, 0), Rotation<2>(0.3)}, {Vector2(0, 2), Rotation<2>(1)}};
    std::vector<Contact<2>> contacts(3, Contact<2>{0, 1});
    contacts[1].second = Contact<2>::wallAsSecond(0);
    contacts[2] = Contact<2>{1, Contact<2>::wallAsSecond(1)};
    contacts[0].force = Vector2(0, -5);
    contacts[1].force = Vector2(0, 5);
    contacts[2].force = Vector2(0, -5);
    contacts[1].point = Vector2(0, -1);
    contacts[2].point = Vector2(0, 3);
    for (Contact<2>& contact : contacts)
    {
        contact.depth = 1e-4;
    }
    const auto branch = [&](const Contact<2>& contact) { return branchVector(contact, bodies); };
    // A column of width 2 and height 4 under the force 5.
    EXPECT_EQ(meanStress(contacts, branch, 8), rows(Vector2(0, 0), Vector2(0, 2.5)));
    const StressMeasures measures = stressMeasures(meanStress(contacts, branch, 8));
    EXPECT_DOUBLE_EQ(measures.direction.value(), M_PI / 2);
    EXPECT_DOUBLE_EQ(measures.mobilisedFriction.value(), M_PI / 2);

    EXPECT_EQ(forceOnWall(contacts, 0), Vector2(0, -5));
    EXPECT_EQ(forceOnWall(contacts, 1), Vector2(0, 5));
}

TEST(Stress, hexagonalLatticeIsIsotropic)
{
    const Eigen::Matrix2d stress = stressOf(hexagonalLattice(4, 6, 0.5, 3));
    EXPECT_NEAR(stress(0, 0), std::sqrt(3) * 6, 1e-13);
    EXPECT_NEAR(stress(1, 1), std::sqrt(3) * 6, 1e-13);
    EXPECT_NEAR(stress(0, 1), 0, 1e-13);
    EXPECT_NEAR(stress(1, 0), 0, 1e-13);
}

TEST(Stress, wallsFeelTheMeanStress)
{
    const double d = 0.5;
    const ContactScene scene = boxedLattice(4, 8, d, Vector2(6, 1), Vector2(1, 2));
    const Eigen::Matrix2d stress = stressOf(scene);
    EXPECT_EQ(stress, rows(Vector2(12, 2), Vector2(2, 4)));
    const Vector2 normals[] = {Vector2(1, 0), Vector2(-1, 0), Vector2(0, 1), Vector2(0, -1)};
    for (std::size_t wall = 0; wall < 4; ++wall)
    {
        const double length = wall < 2 ? 8 * d : 4 * d;
        const WallStress onWall = wallStress(forceOnWall(scene.contacts, wall), normals[wall], length);
        const Vector2 outward = -normals[wall];
        EXPECT_DOUBLE_EQ(onWall.normal, outward.dot(stress * outward));
        EXPECT_DOUBLE_EQ(onWall.shear, outward.dot(stress * perpendicular(outward)));
    }
}

TEST(Stress, turnsWithTheScene)
{
    RandomSource random(71);
    for (int i = 0; i < 50; ++i)
    {
        const ContactScene scene = randomScene(random);
        const double angle = random.uniform(-10, 10);
        const Eigen::Matrix2d stress = stressOf(scene);
        const Eigen::Matrix2d turnedStress = stressOf(turned(scene, angle));
        EXPECT_LE((turnedStress - turned(stress, angle)).norm(), 1e-14 * 40 * stress.norm());
        const StressMeasures before = stressMeasures(stress);
        const StressMeasures after = stressMeasures(turnedStress);
        EXPECT_NEAR(after.mean, before.mean, 1e-13 * before.mean);
        EXPECT_NEAR(after.deviatoric, before.deviatoric, 1e-12 * before.mean);
        EXPECT_LE(axisDistance(after.direction.value(), before.direction.value() + angle), 1e-10);
        EXPECT_NEAR(after.mobilisedFriction.value(), before.mobilisedFriction.value(), 1e-12);
    }
}

TEST(Stress, sameWhicheverBodyIsFirst)
{
    RandomSource random(72);
    ContactScene scene = randomScene(random);
    const Eigen::Matrix2d stress = stressOf(scene);
    for (std::size_t i = 0; i < scene.contacts.size(); ++i)
    {
        scene.contacts[i].normal *= -1;
        scene.contacts[i].force *= -1;
        scene.branches[i] *= -1;
    }
    EXPECT_EQ(stressOf(scene), stress);
}

TEST(Stress, zeroWithoutContacts)
{
    ContactScene scene = squareLattice(2, 2, 1, Vector2(1, 0), Vector2(0, 1));
    for (Contact<2>& contact : scene.contacts)
    {
        contact.depth = 0;
    }
    EXPECT_EQ(stressOf(scene), Eigen::Matrix2d(Eigen::Matrix2d::Zero()));
    EXPECT_EQ(forceOnWall(scene.contacts, 0), Vector2(0, 0));
    const StressMeasures measures = stressMeasures(stressOf(scene));
    EXPECT_EQ(measures.mean, 0);
    EXPECT_FALSE(measures.direction);
    EXPECT_FALSE(measures.mobilisedFriction);
}

TEST(Stress, noFrictionHoldsTension)
{
    EXPECT_FALSE(stressMeasures(rows(Vector2(3, 0), Vector2(0, -1))).mobilisedFriction);
    EXPECT_FALSE(stressMeasures(rows(Vector2(-3, 0), Vector2(0, -1))).mobilisedFriction);
    EXPECT_EQ(stressMeasures(rows(Vector2(3, 0), Vector2(0, 3))).mobilisedFriction, 0.0);
}

TEST(Stress, refusesAreasAndLengthsThatAreNone)
{
    const ContactScene scene = squareLattice(2, 2, 1, Vector2(1, 0), Vector2(0, 1));
    const double bad[] = {0, -1, std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::quiet_NaN()};
    for (const double size : bad)
    {
        EXPECT_THROW(meanStress(scene.contacts, scene.branch(), size), ValueError);
        EXPECT_THROW(wallStress(Vector2(1, 0), Vector2(0, 1), size), ValueError);
    }
}
