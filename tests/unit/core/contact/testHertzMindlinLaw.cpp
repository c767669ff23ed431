#include "core/contact/hertzMindlinLaw.hpp"

#include "core/contact/restitution.hpp"
#include "unit/core/contact/impact.hpp"

#include <gtest/gtest.h>

using namespace chesil;

namespace
{

HertzMindlinLaw lawOf(const ElasticMaterial& a, const ElasticMaterial& b)
{
    HertzMindlinLaw law;
    law.effectiveModulus = effectiveModulusOf(a, b);
    law.effectiveShearModulus = effectiveShearModulusOf(a, b);
    return law;
}

/// Hertz (1882): largest overlap, force and duration of an elastic impact of mass m, radius r and speed v.
void expectHertz(const test::Impact& impact, const HertzMindlinLaw& law, double mass, double radius, double speed)
{
    const double stiffness = 4.0 / 3.0 * law.effectiveModulus * std::sqrt(radius);
    const double depth = std::pow(1.25 * mass * speed * speed / stiffness, 0.4);
    EXPECT_NEAR(impact.largestDepth / depth, 1, 1e-5);
    EXPECT_NEAR(impact.largestForce / (stiffness * std::pow(depth, 1.5)), 1, 1e-5);
    EXPECT_NEAR(impact.duration / (2.94327 * depth / speed), 1, 1e-3);
    EXPECT_NEAR(impact.normal / speed, 1, 1e-5);
}

} // namespace

TEST(HertzMindlinLaw, spheresOfChungAndOoiOne)
{
    // Two like spheres of 10 mm at 10 m/s each: half the mass at 20 m/s.
    struct Case
    {
        ElasticMaterial material;
        double density, overlap, force, duration;
    };
    for (const Case& c : {Case{{48e9, 0.2}, 2800, 274.1e-6, 10.70e3, 40.3e-6}, Case{{20e9, 0.25}, 2500, 368.3e-6, 7.108e3, 54.2e-6}})
    {
        const HertzMindlinLaw law = lawOf(c.material, c.material);
        const test::Sphere sphere{0.01, c.density};
        const test::Impact impact = test::impactOf(law, sphere, 0.005, sphere.mass() / 2, 20, 0, 1e-9);
        expectHertz(impact, law, sphere.mass() / 2, 0.005, 20);
        EXPECT_NEAR(impact.largestDepth / c.overlap, 1, 2e-3);
        EXPECT_NEAR(impact.largestForce / c.force, 1, 2e-3);
        EXPECT_NEAR(impact.duration / c.duration, 1, 3e-3);
    }
}

TEST(HertzMindlinLaw, spheresOfChungAndOoiTwo)
{
    struct Case
    {
        ElasticMaterial material;
        double density, overlap, force, duration;
    };
    for (const Case& c : {Case{{70e9, 0.30}, 2699, 49.7e-6, 11.37e3, 732e-6}, Case{{40e9, 0.35}, 1800, 52.1e-6, 7.233e3, 767e-6}})
    {
        const HertzMindlinLaw law = lawOf(c.material, {1e30, 0});
        const test::Sphere sphere{0.1, c.density};
        const test::Impact impact = test::impactOf(law, sphere, 0.1, sphere.mass(), 0.2, 0, 2e-8);
        expectHertz(impact, law, sphere.mass(), 0.1, 0.2);
        // As printed if the plane is rigid.
        EXPECT_NEAR(impact.largestDepth / c.overlap, 1, 2e-3);
        EXPECT_NEAR(impact.largestForce / c.force, 1, 2e-3);
        EXPECT_NEAR(impact.duration / c.duration, 1, 3e-3);
    }
}

TEST(HertzMindlinLaw, theWantedRestitutionAtAnySpeed)
{
    const test::Sphere sphere{0.0025, 4000};
    for (const double wanted : {1.0, 0.8, 0.6, 0.4, 0.2})
    {
        HertzMindlinLaw law = lawOf({380e9, 0.23}, {70e9, 0.25});
        law.dampingRatio = dampingRatioOf(wanted);
        for (const double speed : {0.01, 3.9})
        {
            const double duration = 2.94 * std::pow(sphere.mass() / law.effectiveModulus, 0.4) / std::pow(speed * sphere.radius, 0.2);
            const test::Impact impact = test::impactOf(law, sphere, sphere.radius, sphere.mass(), speed, 0, duration / 20000);
            EXPECT_NEAR(impact.normal / speed, wanted, 1e-3) << wanted << " at " << speed;
        }
    }
}

TEST(HertzMindlinLaw, grossSlipOfChungAndOoiFour)
{
    // e_t = 1 - mu (1 + e)/tan(theta), spin = -(5/2) mu (1 + e) v_n/r.
    const test::Sphere sphere{0.0025, 4000};
    HertzMindlinLaw law = lawOf({380e9, 0.23}, {70e9, 0.25});
    law.friction = 0.092;
    law.dampingRatio = dampingRatioOf(0.98);
    struct Case
    {
        double degrees, tangential, spin;
    };
    for (const Case& c : {Case{30, 0.685, 615}, Case{45, 0.818, 502}, Case{60, 0.895, 355}})
    {
        const double angle = c.degrees * M_PI / 180;
        const double normal = 3.9 * std::cos(angle);
        const double tangential = 3.9 * std::sin(angle);
        const test::Impact impact = test::impactOf(law, sphere, sphere.radius, sphere.mass(), normal, tangential, 1e-9);
        EXPECT_NEAR(impact.tangential / tangential, c.tangential, 2e-3) << c.degrees;
        EXPECT_NEAR(-impact.spin, c.spin, 2e-3 * c.spin) << c.degrees;
        EXPECT_NEAR(impact.tangential / tangential, 1 - 0.092 * 1.98 / std::tan(angle), 1e-3);
    }
}

TEST(HertzMindlinLaw, noEnergyIsMadeByLoadingUnderShear)
{
    // Pressed, sheared, pressed further, sheared back, let go: no cycle gives back more than it took.
    HertzMindlinLaw law = lawOf({1e9, 0.3}, {1e9, 0.3});
    law.friction = 10;
    const Vector2 normal(0, 1);
    for (const double shear : {1e-6, 1e-5, -1e-5})
    {
        double spring = 0;
        double work = 0;
        double depth = 1e-5;
        double before = depth;
        const auto go = [&](double deeper, double aside, int steps)
        {
            for (int step = 0; step < steps; ++step)
            {
                before = depth;
                depth += deeper / steps;
                const Vector2 velocity(aside / steps, deeper / steps);
                ContactState<2> state{depth, normal, velocity, 1, 0.01, before};
                work -= contactForce(law, state, 1.0, &spring).force.dot(velocity);
            }
        };
        go(0, shear, 1000);
        go(2e-5, 0, 1000);
        go(0, -shear, 1000);
        go(-2e-5, 0, 1000);
        EXPECT_GT(work, -1e-3 * law.springs(ContactState<2>{1e-5, normal, normal, 1, 0.01, 1e-5}).tangentialStiffness * shear * shear)
            << shear;
    }
}

TEST(HertzMindlinLaw, moduliOfAPair)
{
    const ElasticMaterial glass{70e9, 0.25};
    // G = E/(2 (1 + nu)) = 28 GPa: 1/(2 (2 - nu)/G) = 8 GPa.
    EXPECT_NEAR(effectiveModulusOf(glass, glass), 70e9 / (2 * (1 - 0.0625)), 1);
    EXPECT_NEAR(effectiveShearModulusOf(glass, glass), 8e9, 1);
    const ElasticMaterial rigid{1e30, 0};
    EXPECT_NEAR(effectiveModulusOf(glass, rigid), 70e9 / (1 - 0.0625), 1e3);
}
