#include "benchmarks/common/benchmark.hpp"
#include "validation/dry/report.hpp"
#include "validation/dry/scene.hpp"

#include <cmath>

namespace chesil::dry
{

namespace
{

constexpr double speed = 0.1;

struct Outcome
{
    double restitution;
    double duration;
};

/// The damped oscillator from contact until its force is zero again (restitution.hpp): t = 2 arccos(z)/(w sqrt(1 - z^2)).
double durationOf(double dampingRatio, double frequency)
{
    const double square = dampingRatio * dampingRatio;
    const double angle = square < 1 ? std::acos(dampingRatio) : std::acosh(dampingRatio);
    return 2 * angle / (frequency * std::sqrt(std::abs(1 - square)));
}

/// Two like grains that touch meet head on along x, in `steps` steps a half period of the undamped contact.
Outcome headOn(const Shape& shape, double restitution, int steps)
{
    WorldSettings settings = linearScene(shape, restitution, 0);
    const double reach = support(shape, Vector2::UnitX()).x();
    settings.grains = {grainAt(Vector2(-reach, 0), Vector2(speed / 2, 0)), grainAt(Vector2(reach, 0), Vector2(-speed / 2, 0), M_PI)};
    World world(settings);
    const double frequency = std::sqrt(2e6 / massOf(world));
    const double timeStep = M_PI / frequency / steps;
    world.updateForces();
    double last = 0;
    double before = 0;
    double end = 0;
    for (int step = 0; step < 4 * steps; ++step)
    {
        advance(world, timeStep);
        const double force = world.contacts().empty() ? 0 : world.contacts()[0].force.norm();
        if (force == 0 && last > 0)
        {
            // Where the line through the last two forces has its zero.
            end = world.time() - timeStep + timeStep * last / (before - last);
        }
        before = last;
        last = force;
    }
    const Bodies<2>& bodies = world.bodies();
    return {(bodies.velocity[1].x() - bodies.velocity[0].x()) / speed, end * frequency};
}

/// Order of the duration's error in the time step by least squares, and the restitution's error over the step. The order is
/// that of one scheme: from 400 steps a contact on no dashpot here looks ahead (decision 18), below it errors are smaller.
void refineStep(Report& report, const Shape& shape, double wanted)
{
    const std::string tail = "e " + std::to_string(wanted).substr(0, 3);
    std::vector<double> steps;
    std::vector<double> errors;
    double first = 0;
    for (int count = 50; count <= 6400; count *= 2)
    {
        const Outcome found = headOn(shape, wanted, count);
        if (count >= 400)
        {
            steps.push_back(1.0 / count);
            errors.push_back(std::abs(found.duration - durationOf(dampingRatioOf(wanted), 1)));
        }
        if (wanted < 1)
        {
            const double error = std::abs(found.restitution / wanted - 1);
            first = count == 50 ? error : first;
            report.plot("Restitution over time step", "steps a contact", "relative error", tail, count, error, first * 50 / count);
        }
    }
    report.compareAtLeast("impact", "order of the duration " + tail, benchmark::logarithmicSlope(steps, errors), wanted < 1 ? 1 : 2, 0.2);
}

} // namespace

void impact(Report& report)
{
    const std::vector<NamedShape> shapes{
        {"disk", Circle(0.01)}, {"ellipse 2:1", Ellipse(0.02, 0.01)}, {"polybezier", PolyBezier(test::ellipseSegments(10, 0.02, 0.01))}};
    for (const NamedShape& shape : shapes)
    {
        for (int tenth = 1; tenth <= 10; ++tenth)
        {
            const double wanted = tenth / 10.0;
            const double ratio = dampingRatioOf(wanted);
            const Outcome found = headOn(shape.shape, wanted, 6400);
            const std::string tail = " " + shape.name + " e " + std::to_string(tenth) + "/10";
            report.compare("impact", "restitution" + tail, found.restitution, wanted, 1e-3);
            report.compare("impact", "duration x frequency" + tail, found.duration, durationOf(ratio, 1), 1e-3);
            report.plot("Head-on impact", "restitution asked for", "duration x frequency", shape.name, wanted, found.duration, durationOf(ratio, 1));
        }
        report.drawTheory("Head-on impact", shape.name, 0.1, 1, [](double wanted) { return durationOf(dampingRatioOf(wanted), 1); });
    }
    for (const double wanted : {0.2, 0.5, 1.0})
    {
        refineStep(report, shapes[0].shape, wanted);
    }
}

} // namespace chesil::dry
