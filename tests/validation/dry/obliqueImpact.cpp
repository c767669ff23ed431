#include "unit/core/contact/impact.hpp"

#include "core/contact/hertzMindlinLaw.hpp"
#include "core/contact/linearLaw.hpp"
#include "validation/dry/report.hpp"
#include "validation/dry/scene.hpp"

namespace chesil::dry
{

namespace
{

/// Of Kharaz, Gorham & Salman (2001).
const test::Sphere sphere{0.0025, 4000};
constexpr double speed = 3.9;

HertzMindlinLaw aluminaOnAluminium(double restitution, double friction)
{
    HertzMindlinLaw law;
    const ElasticMaterial ball{380e9, 0.23};
    const ElasticMaterial plate{70e9, 0.25};
    law.effectiveModulus = effectiveModulusOf(ball, plate);
    law.effectiveShearModulus = effectiveShearModulusOf(ball, plate);
    law.dampingRatio = dampingRatioOf(restitution);
    law.friction = friction;
    return law;
}

LinearLaw linearOfKharaz(double restitution, double friction)
{
    LinearLaw law;
    law.normalStiffness = 1.72e7;
    law.tangentialStiffness = 1.48e7;
    law.dampingRatio = dampingRatioOf(restitution);
    law.friction = friction;
    return law;
}

template <class Law>
test::Impact impactAt(const Law& law, double degrees)
{
    const double angle = degrees * M_PI / 180;
    return test::impactOf(law, sphere, sphere.radius, sphere.mass(), speed * std::cos(angle), speed * std::sin(angle), 1e-9);
}

/// Chung & Ooi (2011), test 3: the restitution asked for comes out.
void testThree(Report& report)
{
    for (const double wanted : {0.2, 0.4, 0.6, 0.8, 1.0})
    {
        const std::string tail = " e " + std::to_string(wanted).substr(0, 3);
        report.compare("oblique", "test 3 restitution Hertz-Mindlin" + tail, impactAt(aluminaOnAluminium(wanted, 0), 0).normal / speed, wanted, 2e-3);
        report.compare("oblique", "test 3 restitution linear" + tail, impactAt(linearOfKharaz(wanted, 0), 0).normal / speed, wanted, 2e-3);
    }
}

/// Test 4, in gross slip: e_t = 1 - mu (1 + e)/tan(theta), spin 5/2 mu (1 + e) v_n/r.
void testFour(Report& report)
{
    const auto spinAt = [](double degrees) { return 2.5 * 0.092 * 1.98 * speed * std::cos(degrees * M_PI / 180) / sphere.radius; };
    for (int degrees = 5; degrees <= 85; degrees += 5)
    {
        const test::Impact found = impactAt(aluminaOnAluminium(0.98, 0.092), degrees);
        const double angle = degrees * M_PI / 180;
        const double ratio = found.tangential / (speed * std::sin(angle));
        const double theory = 1 - 0.092 * 1.98 / std::tan(angle);
        const double spin = spinAt(degrees);
        if (degrees >= 30)
        {
            report.compare("oblique", "test 4 tangential restitution at " + std::to_string(degrees), ratio, theory, 2e-3);
            report.compare("oblique", "test 4 spin [rad/s] at " + std::to_string(degrees), -found.spin, spin, 2e-3);
            report.plot("Chung & Ooi 4", "angle of impact [deg]", "spin [rad/s]", "Hertz-Mindlin", degrees, -found.spin, spin);
        }
    }
    report.drawTheory("Chung & Ooi 4", "Hertz-Mindlin", 30, 85, spinAt);
}

/// Rebound angles that linear springs give in Kharaz's set-up.
void kharaz(Report& report)
{
    const double table[][2] = {{5, 3.989}, {10, 6.595}, {20, 12.211}, {30, 21.476}, {45, 39.209}, {60, 57.137}};
    for (const auto& [degrees, theory] : table)
    {
        const test::Impact found = impactAt(linearOfKharaz(1, 0.092), degrees);
        const double rebound = std::atan2(found.tangential, found.normal) * 180 / M_PI;
        report.compare("oblique", "Kharaz rebound [deg; error over 45] at " + std::to_string(static_cast<int>(degrees)), rebound, theory, 2e-3, 45);
        report.plot("Kharaz", "angle of impact [deg]", "angle of rebound [deg]", "linear", degrees, rebound, theory);
    }
}

/// The whole engine: a disk slips on a wall; like test 4 with a disk's inertia, spin 2 mu (1 + e) v_n/r.
/// That is for a hard contact: the engine's force acts in the middle of the overlap d, at the arm r - d/2, so at 1 MN/m the spin
/// is 0.2 % less. Here d/r < 1e-3.
void diskOnWall(Report& report)
{
    constexpr double radius = 0.01;
    constexpr double friction = 0.1;
    for (const int degrees : {45, 60, 75})
    {
        const double angle = degrees * M_PI / 180;
        WorldSettings settings = linearScene(Circle(radius), 0.8, friction);
        settings.linear().normalStiffness = 1e8;
        settings.linear().tangentialStiffness = 1e8;
        settings.walls = {floorWall()};
        settings.grains = {grainAt(Vector2(0, radius), 0.1 * Vector2(std::sin(angle), -std::cos(angle)))};
        World world(settings);
        const double duration = M_PI * std::sqrt(massOf(world) / 1e8);
        advanceTo(world, 2 * duration, duration / 6400);
        const double spin = 2 * friction * 1.8 * 0.1 * std::cos(angle) / radius;
        const double ratio = world.bodies().velocity[0].x() / (0.1 * std::sin(angle));
        report.compare("oblique", "disk on wall tangential restitution at " + std::to_string(degrees), ratio, 1 - friction * 1.8 / std::tan(angle), 1e-3);
        report.compare("oblique", "disk on wall spin [rad/s] at " + std::to_string(degrees), std::abs(world.bodies().angularVelocity[0]), spin, 1e-3);
    }
}

} // namespace

void obliqueImpact(Report& report)
{
    testThree(report);
    testFour(report);
    kharaz(report);
    diskOnWall(report);
}

} // namespace chesil::dry
