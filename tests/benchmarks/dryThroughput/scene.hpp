#pragma once

#include "benchmarks/dryThroughput/grainTemplates.hpp"
#include "core/base/randomNumbers.hpp"
#include "core/world/world.hpp"

#include <fstream>
#include <optional>
#include <stdexcept>

/// A packing that one of all codes can go on from.
namespace chesil::benchmark
{

/// [1/s].
constexpr double shearRate = 0.012;
/// [N/m]; Coulomb coefficient; [kg/m3]; the dashpots' coefficient over the pair's effective mass [1/s].
constexpr double normalStiffness = 1e5;
constexpr double friction = 0.5;
constexpr double sceneDensity = 1;
constexpr double dampingRate = 50;
/// [s].
constexpr double sceneTimeStep = 2e-4;

/// Solid fractions at which these have as many contacts.
constexpr double diskFraction = 0.845;
constexpr double polyBezierFraction = 0.87;
constexpr double polygonFraction = 0.86;

enum class Grains
{
    disks,
    polyBeziers,
    polygons,
};

inline std::vector<NamedShape> templatesOf(Grains grains)
{
    switch (grains)
    {
    case Grains::disks:
        return diskTemplates();
    case Grains::polyBeziers:
        return polyBezierTemplates();
    case Grains::polygons:
        return polygonTemplates();
    }
    return {};
}

/// What holds the grains: a periodic cell in simple shear, or four walls that follow the pure shear of that
/// rate.
enum class Bounds
{
    cell,
    walls,
};

/// Lattice vectors, or the box's sides along x and y, from the origin [m]; velocities of the grains are the
/// full ones.
struct Scene
{
    Grains kind = Grains::disks;
    Bounds bounds = Bounds::cell;
    Vector2 first = Vector2::Zero();
    Vector2 second = Vector2::Zero();
    std::vector<GrainState> grains;

    static Eigen::Matrix2d velocityGradient()
    {
        Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
        gradient(0, 1) = shearRate;
        return gradient;
    }

    /// Of the moving walls at `second` and `first` [m/s].
    Vector2 lidVelocity() const { return -shearRate / 2 * second; }
    Vector2 sideVelocity() const { return shearRate / 2 * first; }
};

inline LinearLaw sceneLaw()
{
    LinearLaw law;
    law.normalStiffness = normalStiffness;
    law.tangentialStiffness = 2.0 / 7 * normalStiffness;
    law.friction = friction;
    // A pair of grains of the mean size has LAMMPS's damping, whose rate does not depend on the mass.
    const double effectiveMass = sceneDensity * M_PI / 4 / 2;
    law.dampingRatio = dampingRate / 2 * std::sqrt(effectiveMass / normalStiffness);
    return law;
}

/// For our engine.
inline WorldSettings settingsOf(const Scene& scene)
{
    WorldSettings settings;
    settings.shapes = templatesOf(scene.kind);
    settings.materials[0].density = sceneDensity;
    settings.linear() = sceneLaw();
    settings.grains = scene.grains;
    if (scene.bounds == Bounds::walls)
    {
        settings.walls = {{"floor", Vector2::Zero(), Vector2::UnitY()},
                          {"left", Vector2::Zero(), Vector2::UnitX()},
                          {"lid", scene.second, -Vector2::UnitY(), 0, DrivenWall{scene.lidVelocity()}},
                          {"right", scene.first, -Vector2::UnitX(), 0, DrivenWall{scene.sideVelocity()}}};
        return settings;
    }
    settings.cell.emplace(PeriodicCell(Vector2::Zero(), scene.first, scene.second),
                          Scene::velocityGradient());
    for (GrainState& grain : settings.grains)
    {
        grain.velocity -= settings.cell->flow(grain.position);
    }
    return settings;
}

/// Moves all grains into the cell, or into the rectangle of its height and width.
inline void wrap(Scene& scene)
{
    const PeriodicCell cell(Vector2::Zero(), scene.first, scene.second);
    for (GrainState& grain : scene.grains)
    {
        const Vector2 before = grain.position;
        cell.wrap(grain.position);
        if (scene.bounds == Bounds::walls)
        {
            grain.position.x() -= std::floor(grain.position.x() / scene.first.x()) * scene.first.x();
        }
        grain.velocity += Scene::velocityGradient() * (grain.position - before);
    }
}

/// At random, as in a packing that has been poured or mixed, or such that near grains have near numbers.
enum class Numbering
{
    random,
    byPlace,
};

/// The cell repeated along its vectors.
inline Scene tiled(const Scene& scene, int alongFirst, int alongSecond, Numbering numbering)
{
    Scene result = scene;
    result.first *= alongFirst;
    result.second *= alongSecond;
    result.grains.clear();
    for (int j = 0; j < alongSecond; ++j)
    {
        for (int i = 0; i < alongFirst; ++i)
        {
            const Vector2 offset = i * scene.first + j * scene.second;
            for (GrainState grain : scene.grains)
            {
                grain.position += offset;
                grain.velocity += Scene::velocityGradient() * offset;
                result.grains.push_back(grain);
            }
        }
    }
    wrap(result);
    if (numbering == Numbering::random)
    {
        RandomEngine engine(templateSeed);
        shuffle(result.grains, engine);
        return result;
    }
    const auto place = [](const GrainState& grain)
    { return std::pair(std::floor(grain.position.y() / largestDiameter), grain.position.x()); };
    std::sort(result.grains.begin(), result.grains.end(),
              [&](const GrainState& a, const GrainState& b) { return place(a) < place(b); });
    return result;
}

/// Of each grain; one with a wall counts once.
inline double contactsAGrain(const World& world)
{
    double ends = 0;
    for (std::size_t k = 0; k < world.contacts().size(); ++k)
    {
        const Contact<2>& contact = world.contacts()[k];
        const bool counted = contact.place == 1 && world.contacts()[k - 1].depth > 0;
        if (contact.depth > 0 && !counted)
        {
            ends += contact.withWall() ? 1 : 2;
        }
    }
    return ends / static_cast<double>(world.bodies().size());
}

inline void writeScene(const Scene& scene, const std::string& path)
{
    std::ofstream file(path);
    file.precision(17);
    file << static_cast<int>(scene.kind) << ' ' << static_cast<int>(scene.bounds) << '\n'
         << scene.first.transpose() << ' ' << scene.second.transpose() << '\n'
         << scene.grains.size() << '\n';
    for (const GrainState& grain : scene.grains)
    {
        file << grain.shape << ' ' << grain.position.transpose() << ' ' << grain.angle << ' '
             << grain.velocity.transpose() << ' ' << grain.angularVelocity << '\n';
    }
    if (!file.flush())
    {
        throw std::runtime_error("cannot write " + path);
    }
}

inline Scene readScene(const std::string& path)
{
    std::ifstream file(path);
    Scene scene;
    int kind = 0;
    int bounds = 0;
    std::size_t number = 0;
    file >> kind >> bounds >> scene.first.x() >> scene.first.y() >> scene.second.x() >> scene.second.y() >>
        number;
    scene.kind = static_cast<Grains>(kind);
    scene.bounds = static_cast<Bounds>(bounds);
    scene.grains.resize(number);
    for (GrainState& grain : scene.grains)
    {
        file >> grain.shape >> grain.position.x() >> grain.position.y() >> grain.angle >>
            grain.velocity.x() >> grain.velocity.y() >> grain.angularVelocity;
    }
    if (!file)
    {
        throw std::runtime_error("cannot read " + path);
    }
    return scene;
}

} // namespace chesil::benchmark
