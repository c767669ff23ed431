#include "core/measure/polarHistogram.hpp"

#include "core/base/setupError.hpp"
#include "unit/core/measure/directedContacts.hpp"

#include <gtest/gtest.h>

using namespace chesil;
using namespace chesil::test;

TEST(PolarHistogram, squareLattice)
{
    const ContactScene scene = squareLattice(3, 3, 1, Vector2(4, 1), Vector2(1, 2));
    const std::vector<PolarBin> bins = polarHistogram(scene.contacts, 4, WallContacts::counted);
    ASSERT_EQ(bins.size(), 4u);
    EXPECT_EQ(bins[0].contacts, 9u);
    EXPECT_EQ(bins[2].contacts, 9u);
    EXPECT_EQ(bins[0].normalForce, 4.0);
    EXPECT_EQ(bins[2].normalForce, 2.0);
    EXPECT_EQ(bins[0].tangentialForce, 1.0);
    EXPECT_EQ(bins[2].tangentialForce, -1.0);
    // Half of the contacts in two opposite bins of pi/4 each.
    EXPECT_DOUBLE_EQ(bins[0].density, 0.5 / (M_PI / 2));
    for (const std::size_t empty : {1, 3})
    {
        EXPECT_EQ(bins[empty].contacts, 0u);
        EXPECT_EQ(bins[empty].density, 0);
        EXPECT_FALSE(bins[empty].normalForce);
        EXPECT_FALSE(bins[empty].tangentialForce);
    }
}

TEST(PolarHistogram, followsTheSeriesItIsDrawnFrom)
{
    const DirectedForces given{0.5, 0.4, 3, 0.6, 1.1, 0.3, 2};
    const std::size_t count = 18;
    const std::vector<PolarBin> bins =
        polarHistogram(given.quadrature(20000).contacts, count, WallContacts::counted);
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k)
    {
        const double t = M_PI * static_cast<double>(k) / count;
        // Means over a bin differ from the value in its middle by its width squared.
        EXPECT_NEAR(bins[k].density, (1 + given.a * std::cos(2 * (t - given.ta))) / (2 * M_PI), 1e-3);
        EXPECT_NEAR(bins[k].normalForce.value(), given.normal(t), 0.02);
        EXPECT_NEAR(bins[k].tangentialForce.value(), given.tangential(t), 0.02);
        sum += bins[k].density * 2 * M_PI / count;
    }
    EXPECT_NEAR(sum, 1, 1e-14);
}

TEST(PolarHistogram, turnsByWholeBins)
{
    RandomSource random(79);
    const ContactScene scene = DirectedForces{0.5, 0.4, 3, 0.6, 1.1, 0.3, 2}.drawn(500, random);
    const std::vector<PolarBin> before = polarHistogram(scene.contacts, 12, WallContacts::counted);
    const std::vector<PolarBin> after =
        polarHistogram(turned(scene, 5 * M_PI / 12).contacts, 12, WallContacts::counted);
    for (std::size_t k = 0; k < 12; ++k)
    {
        EXPECT_EQ(after[(k + 5) % 12].contacts, before[k].contacts);
        EXPECT_NEAR(after[(k + 5) % 12].normalForce.value(), before[k].normalForce.value(), 1e-13);
    }
}

TEST(PolarHistogram, emptyWithoutContacts)
{
    ContactScene scene;
    scene.add(0, -1, Vector2(1, 0), Vector2(1, 0));
    for (const PolarBin& bin : polarHistogram(scene.contacts, 3, WallContacts::leftOut))
    {
        EXPECT_EQ(bin.contacts, 0u);
        EXPECT_EQ(bin.density, 0);
        EXPECT_FALSE(bin.normalForce);
    }
    EXPECT_EQ(polarHistogram(scene.contacts, 3, WallContacts::counted)[0].contacts, 1u);
    EXPECT_THROW(polarHistogram(scene.contacts, 0, WallContacts::counted), ValueError);
}
