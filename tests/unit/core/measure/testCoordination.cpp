#include "core/measure/coordination.hpp"

#include "core/base/setupError.hpp"
#include "unit/core/measure/contactScenes.hpp"
#include "unit/randomGrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace chesil;
using namespace chesil::test;

namespace
{

using Histogram = std::vector<std::size_t>;

std::vector<Contact<2>> touching(const std::vector<std::pair<int, int>>& pairs)
{
    std::vector<Contact<2>> contacts;
    for (const auto& [first, second] : pairs)
    {
        contacts.push_back({first, second});
        contacts.back().depth = 1e-3;
    }
    return contacts;
}

} // namespace

TEST(Coordination, lattices)
{
    const ContactScene square = squareLattice(4, 5, 1, Vector2(1, 0), Vector2(0, 1));
    EXPECT_EQ(coordination(square.contacts, square.grains, 2, WallContacts::counted).mean, 4.0);
    const ContactScene hexagonal = hexagonalLattice(4, 6, 1, 1);
    const Coordination six = coordination(hexagonal.contacts, hexagonal.grains, 3, WallContacts::counted);
    EXPECT_EQ(six.mean, 6.0);
    EXPECT_EQ(six.meanWithoutRattlers, 6.0);
    EXPECT_EQ(six.rattlers, 0u);
    EXPECT_EQ(six.rattlerShare, 0.0);
    EXPECT_EQ(six.histogram, (Histogram{0, 0, 0, 0, 0, 0, 24}));
}

TEST(Coordination, wallsCountIfAsked)
{
    const ContactScene box = boxedLattice(3, 3, 1, Vector2(1, 0), Vector2(0, 1));
    const Coordination counted = coordination(box.contacts, box.grains, 3, WallContacts::counted);
    EXPECT_EQ(counted.mean, 4.0);
    EXPECT_EQ(counted.histogram, (Histogram{0, 0, 0, 0, 9}));
    EXPECT_EQ(counted.rattlers, 0u);
    // Corners have 2 neighbours then, and without them the edges' middles have 1, and the centre none.
    const Coordination leftOut = coordination(box.contacts, box.grains, 3, WallContacts::leftOut);
    EXPECT_DOUBLE_EQ(leftOut.mean.value(), 24.0 / 9);
    EXPECT_EQ(leftOut.histogram, (Histogram{0, 0, 4, 4, 1}));
    EXPECT_EQ(leftOut.rattlers, 9u);
    EXPECT_FALSE(leftOut.meanWithoutRattlers);
}

/// A triangle with a tail of two, a pair and a lonely grain.
TEST(Coordination, rattlersGoOneAfterTheOther)
{
    const std::vector<Contact<2>> contacts = touching({{0, 1}, {0, 2}, {1, 2}, {2, 3}, {3, 4}, {5, 6}});
    const Coordination found = coordination(contacts, 8, 2, WallContacts::counted);
    EXPECT_EQ(found.mean, 12.0 / 8);
    EXPECT_EQ(found.rattlers, 5u);
    EXPECT_EQ(found.rattlerShare, 5.0 / 8);
    EXPECT_EQ(found.meanWithoutRattlers, 2.0);
    EXPECT_EQ(found.rattles, (std::vector<bool>{false, false, false, true, true, true, true, true}));
    EXPECT_EQ(found.histogram, (Histogram{1, 3, 3, 1}));
    EXPECT_EQ(coordination(contacts, 8, 1, WallContacts::counted).rattlers, 1u);
    EXPECT_EQ(coordination(contacts, 8, 3, WallContacts::counted).rattlers, 8u);
}

TEST(Coordination, bothEndsOfAFlatContactAreOneNeighbour)
{
    std::vector<Contact<2>> contacts = touching({{0, 1}, {0, 1}, {0, -1}, {0, -1}, {0, -2}, {1, 2}});
    contacts[1].place = 1;
    contacts[3].place = 1;
    contacts[5].depth = 0;
    EXPECT_EQ(coordination(contacts, 3, 2, WallContacts::counted).histogram, (Histogram{1, 1, 0, 1}));
    // The first end apart, the second not.
    contacts[0].depth = 0;
    EXPECT_EQ(coordination(contacts, 3, 2, WallContacts::counted).histogram, (Histogram{1, 1, 0, 1}));
}

/// Against the definition, taken literally: drop all that are loose, count again, until none is.
TEST(Coordination, randomGraphsAgainstTheDefinition)
{
    RandomSource random(73);
    for (int round = 0; round < 200; ++round)
    {
        const int grains = random.integer(2, 30);
        std::vector<std::vector<bool>> touch(grains, std::vector<bool>(grains, false));
        std::vector<std::pair<int, int>> pairs;
        for (int k = random.integer(0, 50); k > 0; --k)
        {
            const int i = random.integer(0, grains - 2);
            const int j = random.integer(i + 1, grains - 1);
            touch[i][j] = touch[j][i] = true;
            pairs.push_back({i, j});
        }
        const int least = random.integer(1, 4);
        std::vector<bool> gone(grains, false);
        for (bool changed = true; changed;)
        {
            changed = false;
            const std::vector<bool> before(gone);
            for (int i = 0; i < grains; ++i)
            {
                int neighbours = 0;
                for (int j = 0; j < grains; ++j)
                {
                    neighbours += touch[i][j] && !before[j] ? 1 : 0;
                }
                changed = changed || (!gone[i] && neighbours < least);
                gone[i] = gone[i] || neighbours < least;
            }
        }
        EXPECT_EQ(coordination(touching(pairs), grains, least, WallContacts::counted).rattles, gone);
    }
}

TEST(Coordination, emptySamples)
{
    const Coordination none = coordination({}, 0, 2, WallContacts::counted);
    EXPECT_FALSE(none.mean);
    EXPECT_FALSE(none.rattlerShare);
    EXPECT_TRUE(none.histogram.empty());
    const Coordination apart = coordination({}, 3, 2, WallContacts::counted);
    EXPECT_EQ(apart.mean, 0.0);
    EXPECT_FALSE(apart.meanWithoutRattlers);
    EXPECT_EQ(apart.rattlers, 3u);
    EXPECT_EQ(apart.histogram, (Histogram{3}));
}

TEST(Coordination, refusesGrainsBeyondTheSample)
{
    EXPECT_THROW(coordination(touching({{0, 3}}), 3, 2, WallContacts::counted), ValueError);
    EXPECT_THROW(coordination(touching({{3, -1}}), 3, 2, WallContacts::counted), ValueError);
    EXPECT_THROW(coordination(touching({{0, 1}}), 0, 2, WallContacts::counted), ValueError);
}
