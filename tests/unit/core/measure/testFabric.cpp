#include "core/measure/fabric.hpp"

#include "core/measure/stress.hpp"
#include "unit/core/measure/directedContacts.hpp"

#include <gtest/gtest.h>

using namespace chesil;
using namespace chesil::test;

namespace
{

DirectionalAverages averagesOf(const ContactScene& scene)
{
    return directionalAverages(scene.contacts, WallContacts::counted);
}

/// Harmonics agree as vectors, so that the direction matters as much as the amplitude.
double distance(const SecondHarmonic& found, double amplitude, double direction)
{
    return std::hypot(found.cosine - amplitude * std::cos(2 * direction),
                      found.sine - amplitude * std::sin(2 * direction));
}

DirectedForces randomForces(RandomSource& random)
{
    const double a = random.uniform(0.05, 0.7);
    const double ta = random.uniform(0, M_PI);
    const double f0 = random.logUniform(1e-3, 1e3);
    const double an = random.uniform(0, 0.9);
    const double tn = random.uniform(0, M_PI);
    const double at = random.uniform(0, 0.5);
    return {a, ta, f0, an, tn, at, random.uniform(0, M_PI)};
}

} // namespace

TEST(Fabric, lattices)
{
    const ContactScene scene = squareLattice(3, 3, 1, Vector2(1, 0), Vector2(0, 1));
    const Eigen::Matrix2d square = fabricTensor(scene.contacts, WallContacts::counted).value();
    EXPECT_EQ(square, Eigen::Matrix2d(0.5 * Eigen::Matrix2d::Identity()));
    EXPECT_EQ(fabricAnisotropy(square).amplitude(), 0);
    EXPECT_FALSE(fabricAnisotropy(square).direction());
    const ContactScene hexagonal = hexagonalLattice(4, 4, 1, 2);
    const DirectionalAverages found = averagesOf(hexagonal);
    EXPECT_EQ(found.status, DirectionalStatus::fitted);
    EXPECT_LE(found.normals.amplitude(), 1e-14);
    EXPECT_NEAR(found.normalForce, 2, 1e-14);
    EXPECT_LE(found.normalForces.amplitude(), 1e-14);
    EXPECT_LE(found.tangentialForces.amplitude(), 1e-14);
}

TEST(Fabric, contactsInOneDirection)
{
    ContactScene scene;
    scene.add(0, 1, Vector2(0, 2), Vector2(0, 1));
    const SecondHarmonic found =
        fabricAnisotropy(fabricTensor(scene.contacts, WallContacts::counted).value());
    EXPECT_EQ(found.amplitude(), 2);
    EXPECT_DOUBLE_EQ(found.direction().value(), M_PI / 2);
    EXPECT_EQ(averagesOf(scene).status, DirectionalStatus::densityNotPositive);
    EXPECT_EQ(averagesOf(scene).normals.amplitude(), 2);
    EXPECT_FALSE(averagesOf(scene).stressRatio());
}

TEST(Fabric, wallsCountIfAsked)
{
    ContactScene scene;
    scene.add(0, 1, Vector2(1, 0), Vector2(1, 0));
    scene.add(0, -1, Vector2(0, 1), Vector2(0, 1));
    EXPECT_EQ(fabricTensor(scene.contacts, WallContacts::counted).value()(1, 1), 0.5);
    EXPECT_EQ(fabricTensor(scene.contacts, WallContacts::leftOut).value()(1, 1), 0);
    EXPECT_EQ(averagesOf(scene).status, DirectionalStatus::fitted);
    EXPECT_EQ(directionalAverages(scene.contacts, WallContacts::leftOut).status,
              DirectionalStatus::densityNotPositive);
}

TEST(Fabric, quadratureGivesSeriesExactly)
{
    RandomSource random(74);
    for (int i = 0; i < 100; ++i)
    {
        const DirectedForces given = randomForces(random);
        const DirectionalAverages found = averagesOf(given.quadrature(500));
        ASSERT_EQ(found.status, DirectionalStatus::fitted);
        EXPECT_LE(distance(found.normals, given.a, given.ta), 1e-13);
        EXPECT_NEAR(found.normalForce, given.f0, 1e-13 * given.f0);
        EXPECT_LE(distance(found.normalForces, given.an, given.tn), 1e-13);
        EXPECT_LE(distance(found.tangentialForces, given.at, given.tt), 1e-13);
    }
}

/// The amplitudes' standard deviation is about sqrt(2/N) for the normals, and at most twice that of the
/// scattered forces with the weights of a <= 0.5.
TEST(Fabric, drawnContactsGiveSeriesWithinStatistics)
{
    RandomSource random(75);
    const int count = 20000;
    const double deviation = std::sqrt(2.0 / count);
    for (int i = 0; i < 10; ++i)
    {
        DirectedForces given = randomForces(random);
        given.a *= 0.7;
        const DirectionalAverages found = averagesOf(given.drawn(count, random));
        ASSERT_EQ(found.status, DirectionalStatus::fitted);
        EXPECT_LE(distance(found.normals, given.a, given.ta), 4 * deviation);
        EXPECT_NEAR(found.normalForce, given.f0, 4 * deviation * given.f0);
        EXPECT_LE(distance(found.normalForces, given.an, given.tn), 8 * deviation);
        EXPECT_LE(distance(found.tangentialForces, given.at, given.tt), 8 * deviation);
    }
}

TEST(Fabric, ratioOfAgreeingDirections)
{
    const DirectedForces given{0.3, 0.4, 2, 0.25, 0.4, 0.15, 0.4};
    const ContactScene scene = given.quadrature(500);
    const double ratio = averagesOf(scene).stressRatio().value();
    EXPECT_NEAR(ratio, (0.3 + 0.25 + 0.15) / 2, 1e-13);
    const StressMeasures stress = stressMeasures(meanStress(scene.contacts, scene.branch(), scene.area));
    EXPECT_NEAR(stress.deviatoric / stress.mean, ratio / (1 + 0.3 * 0.25 / 2), 1e-13);
    EXPECT_LE(axisDistance(stress.direction.value(), 0.4), 1e-13);
}

/// Whatever the three directions, the ratio errs by the amplitudes' products only.
TEST(Fabric, ratioIsThatOfTheStressToFirstOrder)
{
    RandomSource random(76);
    for (int i = 0; i < 50; ++i)
    {
        DirectedForces given = randomForces(random);
        given.a *= 1e-4;
        given.an *= 1e-4;
        given.at *= 1e-4;
        const ContactScene scene = given.quadrature(500);
        const StressMeasures stress = stressMeasures(meanStress(scene.contacts, scene.branch(), scene.area));
        EXPECT_NEAR(averagesOf(scene).stressRatio().value(), stress.deviatoric / stress.mean, 2e-8);
    }
}

TEST(Fabric, turnsWithTheScene)
{
    RandomSource random(77);
    for (int i = 0; i < 50; ++i)
    {
        const ContactScene scene = randomForces(random).drawn(100, random);
        const double angle = random.uniform(-10, 10);
        const ContactScene other = turned(scene, angle);
        const Eigen::Matrix2d fabric = fabricTensor(scene.contacts, WallContacts::counted).value();
        const Eigen::Matrix2d otherFabric = fabricTensor(other.contacts, WallContacts::counted).value();
        EXPECT_LE((otherFabric - turned(fabric, angle)).norm(), 1e-13);
        EXPECT_NEAR(otherFabric.trace(), 1, 1e-14);
        const DirectionalAverages before = averagesOf(scene);
        const DirectionalAverages after = averagesOf(other);
        ASSERT_EQ(after.status, before.status);
        const auto turnedBy = [&](const SecondHarmonic& harmonic)
        { return harmonic.direction().value_or(0) + angle; };
        EXPECT_LE(distance(after.normals, before.normals.amplitude(), turnedBy(before.normals)), 1e-12);
        EXPECT_LE(
            distance(after.normalForces, before.normalForces.amplitude(), turnedBy(before.normalForces)),
            1e-11);
        EXPECT_LE(distance(after.tangentialForces, before.tangentialForces.amplitude(),
                           turnedBy(before.tangentialForces)),
                  1e-11);
    }
}

TEST(Fabric, sameWhicheverBodyIsFirst)
{
    RandomSource random(78);
    ContactScene scene = randomForces(random).drawn(100, random);
    const DirectionalAverages before = averagesOf(scene);
    for (Contact<2>& contact : scene.contacts)
    {
        contact.normal *= -1;
        contact.force *= -1;
    }
    const DirectionalAverages after = averagesOf(scene);
    EXPECT_EQ(after.normals.amplitude(), before.normals.amplitude());
    EXPECT_EQ(after.normalForce, before.normalForce);
    EXPECT_EQ(after.tangentialForces.sine, before.tangentialForces.sine);
}

TEST(Fabric, nothingWithoutContacts)
{
    const std::vector<Contact<2>> apart{{0, 1}};
    EXPECT_FALSE(fabricTensor(apart, WallContacts::counted));
    const DirectionalAverages found = directionalAverages(apart, WallContacts::counted);
    EXPECT_EQ(found.status, DirectionalStatus::noContacts);
    EXPECT_EQ(found.normalForce, 0);
    EXPECT_FALSE(found.stressRatio());
}

TEST(Fabric, forcesWithoutNormalPart)
{
    ContactScene scene = squareLattice(2, 2, 1, Vector2(0, 1), Vector2(1, 0));
    const DirectionalAverages found = averagesOf(scene);
    EXPECT_EQ(found.status, DirectionalStatus::noNormalForce);
    EXPECT_EQ(found.tangentialForces.amplitude(), 0);
}
