#pragma once

#include "core/measure/energy.hpp"
#include "core/world/placement.hpp"
#include "core/world/world.hpp"
#include "unit/randomGrain.hpp"

namespace chesil::benchmark
{

/// A packing as in Lai & Huang, section 5.2; the density is not printed there.
struct PackingOptions
{
    int grains = 500;
    std::uint64_t shapeSeed = 20240621;
    std::uint64_t placeSeed = 20240622;
    /// Diameter of the disk of the same area [m].
    double smallest = 0.04;
    double largest = 0.06;
    /// Wide as in the paper, higher than its 3 m, for the lattice to hold them all [m].
    double width = 1;
    double height = 5;
    double stiffness = 1e7;
    double friction = 0.2;
    double localDamping = 0.7;
    double density = 2650;
    double gravity = 9.81;
    double timeStep = 1e-4;
    int steps = 50000;
    int segments = 10;
    int fewestSides = 4;
    int mostSides = 7;
    /// Smallest ratio of an ellipse's half-axes.
    double flattest = 0.5;
};

/// What a length of the given shape of area `area` is multiplied with to make it as wide as the disk.
inline double scaleTo(double diameter, double area) { return diameter / 2 / std::sqrt(area / M_PI); }

inline Shape randomShape(int kind, const PackingOptions& options, test::RandomSource& random)
{
    const double diameter = random.uniform(options.smallest, options.largest);
    if (kind == 0)
    {
        const double ratio = random.uniform(options.flattest, 1);
        return Ellipse(diameter / 2 / std::sqrt(ratio), diameter / 2 * std::sqrt(ratio));
    }
    if (kind == 1)
    {
        const int sides = random.integer(options.fewestSides, options.mostSides);
        const ConvexPolygon polygon = test::randomPolygon(sides, 1, random);
        const double scale = scaleTo(diameter, polygon.massProperties().area);
        std::vector<Vector2> vertices;
        for (const Vector2& vertex : polygon.vertices())
        {
            vertices.push_back(scale * vertex);
        }
        return ConvexPolygon(vertices);
    }
    test::RandomGrainOptions grain;
    grain.segments = options.segments;
    const PolyBezier polyBezier = test::randomPolyBezier(grain, random);
    const double scale = scaleTo(diameter, polyBezier.massProperties().area);
    std::vector<CubicBezier> segments;
    for (const CubicBezier& segment : polyBezier.segments())
    {
        std::array<Vector2, 4> points = segment.controlPoints();
        for (Vector2& point : points)
        {
            point *= scale;
        }
        segments.emplace_back(points);
    }
    return PolyBezier(segments);
}

/// Equal numbers of shapes of each kind, grains drawn from them on a lattice above the floor.
inline WorldSettings packingSettings(const PackingOptions& options)
{
    WorldSettings settings;
    settings.materials[0].density = options.density;
    settings.gravity = Vector2(0, -options.gravity);
    settings.linear().normalStiffness = options.stiffness;
    settings.linear().tangentialStiffness = options.stiffness;
    settings.linear().friction = options.friction;
    settings.localDamping = options.localDamping;
    settings.walls = {{"floor", Vector2::Zero(), Vector2::UnitY()},
                      {"left", Vector2::Zero(), Vector2::UnitX()},
                      {"right", Vector2(options.width, 0), -Vector2::UnitX()}};

    test::RandomSource random(options.shapeSeed);
    std::vector<int> choice;
    for (int i = 0; i < options.grains; ++i)
    {
        settings.shapes.push_back({"grain" + std::to_string(i), randomShape(i % 3, options, random)});
        choice.push_back(i);
    }
    settings.grains =
        placeOnLattice(settings.shapes, choice, options.grains,
                       {Vector2::Zero(), Vector2(options.width, options.height)}, options.placeSeed);
    return settings;
}

/// Two placed grains whose bounding circles overlap, now and a time step before.
struct NearPair
{
    const Shape* a;
    const Shape* b;
    Pose<2> poseA;
    Pose<2> poseB;
    Pose<2> beforeA;
    Pose<2> beforeB;
    double size() const { return boundingRadius(*a) + boundingRadius(*b); }
};

/// Lets the grains settle; the shapes of the pairs are the world's own.
inline void settle(World& world, const PackingOptions& options)
{
    world.updateForces();
    for (int step = 0; step < options.steps; ++step)
    {
        if (world.step(options.timeStep) != StepStatus::done)
        {
            throw std::runtime_error("a grain's motion is no longer finite");
        }
    }
}

/// One more step, and the pairs near each other after it.
inline std::vector<NearPair> nearPairs(World& world, const PackingOptions& options)
{
    const std::vector<Pose<2>> before = world.bodies().pose;
    world.step(options.timeStep);
    const std::vector<Pose<2>>& now = world.bodies().pose;
    std::vector<NearPair> pairs;
    for (const Contact<2>& contact : world.contacts())
    {
        if (contact.withWall())
        {
            continue;
        }
        const std::size_t i = static_cast<std::size_t>(contact.first);
        const std::size_t j = static_cast<std::size_t>(contact.second);
        const NearPair pair{&world.shapeOf(i), &world.shapeOf(j), now[i], now[j], before[i], before[j]};
        if ((now[j].position - now[i].position).norm() <= pair.size())
        {
            pairs.push_back(pair);
        }
    }
    return pairs;
}

} // namespace chesil::benchmark
