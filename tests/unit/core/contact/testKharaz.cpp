#include "core/contact/linearLaw.hpp"

#include "unit/core/contact/impact.hpp"

#include <gtest/gtest.h>

using namespace chesil;

/// Oblique impacts of Kharaz, Gorham & Salman (2001) as linear springs give them: rebound angles of the
/// centre [degrees] for those of the impact.
TEST(LinearLaw, obliqueImpactsOfKharaz)
{
    LinearLaw law;
    law.normalStiffness = 1.72e7;
    law.tangentialStiffness = 1.48e7;
    law.friction = 0.092;
    const test::Sphere sphere{0.0025, 4000};
    constexpr double speed = 3.9;
    const double timeStep = M_PI * std::sqrt(sphere.mass() / law.normalStiffness) / 20000;
    struct Case
    {
        double impact, rebound;
    };
    for (const Case& c :
         {Case{5, 3.989}, Case{10, 6.595}, Case{20, 12.211}, Case{30, 21.476}, Case{45, 39.209}, Case{60, 57.137}})
    {
        const double angle = c.impact * M_PI / 180;
        const test::Impact impact = test::impactOf(
            law, sphere, 0, sphere.mass(), speed * std::cos(angle), speed * std::sin(angle), timeStep);
        EXPECT_NEAR(std::atan2(impact.tangential, impact.normal) * 180 / M_PI, c.rebound, 0.1) << c.impact;
    }
}
