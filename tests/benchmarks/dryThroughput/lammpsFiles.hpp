#pragma once

#include "benchmarks/dryThroughput/scene.hpp"

/// A scene as a data file of LAMMPS, read by disks.lmp and polygons.lmp.
namespace chesil::benchmark
{

inline std::ofstream lammpsFile(const Scene& scene, const std::string& path)
{
    if (scene.first.y() != 0)
    {
        throw std::logic_error("LAMMPS wants a cell whose first vector is along x");
    }
    std::ofstream file(path);
    file.precision(17);
    file << "a scene of dryThroughput\n\n" << scene.grains.size() << " atoms\n1 atom types\n";
    if (scene.kind == Grains::polygons)
    {
        file << scene.grains.size() << " bodies\n";
    }
    file << "0 " << scene.first.x() << " xlo xhi\n0 " << scene.second.y() << " ylo yhi\n-0.6 0.6 zlo zhi\n"
         << scene.second.x() << " 0 0 xy xz yz\n";
    return file;
}

/// Angular velocity, or angular momentum for bodies.
inline void writeVelocities(const Scene& scene, const std::vector<double>& inertia, std::ofstream& file)
{
    file << "\nVelocities\n\n";
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        const GrainState& grain = scene.grains[i];
        file << i + 1 << ' ' << grain.velocity.transpose() << " 0 0 0 "
             << inertia[static_cast<std::size_t>(grain.shape)] * grain.angularVelocity << '\n';
    }
}

inline void writeLammpsDisks(const Scene& scene, const std::string& path)
{
    std::ofstream file = lammpsFile(scene, path);
    file << "\nAtoms # sphere\n\n";
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        const GrainState& grain = scene.grains[i];
        file << i + 1 << " 1 " << templateDiameter(grain.shape) << " 1 " << grain.position.transpose()
             << " 0\n";
    }
    writeVelocities(scene, std::vector<double>(templates, 1), file);
    if (!file.flush())
    {
        throw std::runtime_error("cannot write " + path);
    }
}

/// Each body with its own vertices, turned as it is; only its polar moment matters in the plane.
inline void writeLammpsPolygons(const Scene& scene, const std::string& path)
{
    std::ofstream file = lammpsFile(scene, path);
    std::vector<RoundedPolygon> polygons;
    std::vector<double> inertia;
    const std::vector<NamedShape> shapes = polyBezierTemplates();
    for (int i = 0; i < templates; ++i)
    {
        const Shape& shape = shapes[static_cast<std::size_t>(i)].shape;
        polygons.push_back(roundedPolygonOf(i, shape, lammpsRounding));
        inertia.push_back(sceneDensity * massProperties(shape).polarMoment);
    }
    file << "\nAtoms # body\n\n";
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        const GrainState& grain = scene.grains[i];
        file << i + 1 << " 1 1 " << sceneDensity * templateArea(grain.shape) << ' '
             << grain.position.transpose() << " 0\n";
    }
    writeVelocities(scene, inertia, file);
    file << "\nBodies\n\n";
    for (std::size_t i = 0; i < scene.grains.size(); ++i)
    {
        const GrainState& grain = scene.grains[i];
        const RoundedPolygon& polygon = polygons[static_cast<std::size_t>(grain.shape)];
        const std::size_t sides = polygon.core.size();
        const double polar = inertia[static_cast<std::size_t>(grain.shape)];
        const Rotation<2> turn(grain.angle);
        file << i + 1 << " 1 " << 6 + 3 * sides + 1 << '\n'
             << sides << '\n'
             << polar / 2 << ' ' << polar / 2 << ' ' << polar << " 0 0 0\n";
        for (const Vector2& vertex : polygon.core)
        {
            file << turn.apply(vertex).transpose() << " 0\n";
        }
        file << 2 * polygon.radius << '\n';
    }
    if (!file.flush())
    {
        throw std::runtime_error("cannot write " + path);
    }
}

} // namespace chesil::benchmark
