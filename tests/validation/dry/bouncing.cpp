#include "validation/dry/report.hpp"
#include "validation/dry/scene.hpp"

#include <Eigen/Eigenvalues>

namespace chesil::dry
{

namespace
{

/// A disk falls on a floor; the k-th rebound of hard grains reaches e^(2 k) of the height.
void bounces(Report& report)
{
    constexpr double radius = 0.01;
    constexpr double drop = 0.1;
    constexpr double restitution = 0.8;
    WorldSettings settings = linearScene(Circle(radius), restitution, 0);
    settings.linear().normalStiffness = 1e9;
    settings.gravity = Vector2(0, -gravity);
    settings.walls = {floorWall()};
    settings.grains = {grainAt(Vector2(0, radius + drop))};
    World world(settings);
    world.updateForces();
    const double timeStep = 0.02 * world.stableTimeStep();
    const auto heightAfter = [](double bounce) { return std::pow(restitution, 2 * bounce); };
    double before = 0;
    for (int bounce = 0; bounce <= 4;)
    {
        advance(world, timeStep);
        const double speed = world.bodies().velocity[0].y();
        if (before > 0 && speed <= 0)
        {
            ++bounce;
            const double height = (world.bodies().pose[0].position.y() - radius) / drop;
            const double theory = heightAfter(bounce);
            report.compare("bouncing", "height over drop after bounce " + std::to_string(bounce), height, theory, 2e-3);
            report.plot("Bouncing", "bounce", "height over drop", "e 0.8", bounce, height, theory);
        }
        before = speed;
    }
    report.drawTheory("Bouncing", "e 0.8", 1, 5, heightAfter);
}

/// Two spheres (d 1 mm, 2e4 and 1e4 kg/m3, k 1e3 N/m) squeezed into a gap of 1.8 mm, always in touch: a linear oscillator
/// of two masses. The disks get the density that makes them as heavy as the spheres.
void stackedSpheres(Report& report)
{
    constexpr double radius = 0.0005;
    constexpr double stiffness = 1000;
    constexpr double gap = 0.0018;
    WorldSettings settings = linearScene(Circle(radius), 1, 0);
    settings.linear().normalStiffness = stiffness;
    settings.materials = {{"lower", 2e4 * 4 / 3 * radius}, {"upper", 1e4 * 4 / 3 * radius}};
    LawTable<LinearLaw> laws(2);
    for (const std::size_t material : {0u, 1u})
    {
        laws.set(material, 0, settings.linear());
        laws.set(material, 1, settings.linear());
    }
    settings.contact = laws;
    settings.gravity = Vector2(0, -gravity);
    settings.walls = {floorWall(), {"lid", Vector2(0, gap), -Vector2::UnitY()}};
    const Vector2 start(gap / 4, 3 * gap / 4);
    settings.grains = {grainAt(Vector2(0, start.x())), grainAt(Vector2(0, start.y()))};
    settings.grains[1].material = 1;
    World world(settings);
    world.updateForces();

    // M y'' = b - K y, in the modes of M^-1/2 K M^-1/2.
    const Vector2 masses(1 / world.bodies().inverseMass[0], 1 / world.bodies().inverseMass[1]);
    Eigen::Matrix2d springs;
    springs << 2 * stiffness, -stiffness, -stiffness, 2 * stiffness;
    const Vector2 loads(stiffness * (radius - 2 * radius) - masses.x() * gravity, stiffness * (gap - radius + 2 * radius) - masses.y() * gravity);
    const Vector2 rest = springs.inverse() * loads;
    const Vector2 roots = masses.cwiseSqrt();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> modes(roots.cwiseInverse().asDiagonal() * springs * roots.cwiseInverse().asDiagonal());
    const Vector2 amplitude = modes.eigenvectors().transpose() * (roots.asDiagonal() * (start - rest));

    const double timeStep = 0.02 * world.stableTimeStep();
    const double end = 10 * 2 * M_PI / std::sqrt(modes.eigenvalues().x());
    const auto theoryAt = [&](double time) -> Vector2
    {
        const Vector2 now = amplitude.cwiseProduct((modes.eigenvalues().cwiseSqrt() * time).array().cos().matrix());
        return rest + roots.cwiseInverse().asDiagonal() * (modes.eigenvectors() * now);
    };
    double worst = 0;
    for (int step = 1; world.time() < end; ++step)
    {
        advance(world, timeStep);
        const Vector2 theory = theoryAt(world.time());
        for (const std::size_t grain : {0u, 1u})
        {
            const double height = world.bodies().pose[grain].position.y();
            worst = std::max(worst, std::abs(height - theory[static_cast<Eigen::Index>(grain)]));
            if (step % 40 == 0 && world.time() < end / 5)
            {
                report.plot("Stacked spheres", "time [ms]", "height less start [µm]", grain ? "upper" : "lower", 1e3 * world.time(), 1e6 * (height - start[static_cast<Eigen::Index>(grain)]), 1e6 * (theory[static_cast<Eigen::Index>(grain)] - start[static_cast<Eigen::Index>(grain)]));
            }
        }
    }
    for (const Eigen::Index grain : {0, 1})
    {
        const auto rise = [&](double milliseconds) { return 1e6 * (theoryAt(1e-3 * milliseconds)[grain] - start[grain]); };
        report.drawTheory("Stacked spheres", grain == 1 ? "upper" : "lower", 0, 1e3 * end / 5, rise);
    }
    const double swing = (start - rest).cwiseAbs().maxCoeff();
    report.compare("bouncing", "stacked largest deviation over amplitude (10 periods)", worst / swing, 0, 2e-3, 1);
}

} // namespace

void bouncing(Report& report)
{
    bounces(report);
    stackedSpheres(report);
}

} // namespace chesil::dry
