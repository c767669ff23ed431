#pragma once

#include "benchmarks/dryThroughput/lammpsFiles.hpp"
#include "core/broadphase/neighbourSearch.hpp"
#include "core/world/pairDistance.hpp"

#include <sstream>

/// LAMMPS does not count contacts of polygons: they are counted from the vertices that it has written.
namespace chesil::benchmark
{

/// "dump local" of each vertex: body, x, y.
struct DumpedPolygons
{
    Vector2 first = Vector2::Zero();
    Vector2 second = Vector2::Zero();
    std::vector<std::vector<Vector2>> cores;
};

inline DumpedPolygons readDump(const std::string& path)
{
    std::ifstream file(path);
    DumpedPolygons result;
    std::string line;
    while (std::getline(file, line) && line.rfind("ITEM: ENTRIES", 0) != 0)
    {
        if (line.rfind("ITEM: BOX BOUNDS", 0) == 0)
        {
            double low = 0, high = 0, tilt = 0, bottom = 0, top = 0;
            file >> low >> high >> tilt >> bottom >> top;
            result.first = Vector2(high - low - std::abs(tilt), 0);
            result.second = Vector2(tilt, top - bottom);
        }
    }
    std::size_t body = 0;
    Vector2 vertex;
    while (file >> body >> vertex.x() >> vertex.y())
    {
        result.cores.resize(std::max(result.cores.size(), body));
        result.cores[body - 1].push_back(vertex);
    }
    if (result.cores.empty())
    {
        throw std::runtime_error("cannot read " + path);
    }
    return result;
}

inline double contactsAGrain(const DumpedPolygons& polygons)
{
    const PeriodicCell cell(Vector2::Zero(), polygons.first, polygons.second);
    std::vector<Shape> shapes;
    std::vector<Vector2> centres;
    std::vector<double> radii;
    for (const std::vector<Vector2>& core : polygons.cores)
    {
        const ConvexPolygon polygon(core);
        shapes.emplace_back(polygon);
        centres.push_back(polygon.givenCentroid());
        cell.wrap(centres.back());
        radii.push_back(polygon.boundingRadius());
    }
    NeighbourSearch search;
    double ends = 0;
    for (const PairKey& pair : search.find(centres, {}, radii, 2 * lammpsRounding, cell))
    {
        const auto i = static_cast<std::size_t>(pair.first);
        const auto j = static_cast<std::size_t>(pair.second);
        const Pose<2> image{centres[j] + cell.offset(pair.shift), Rotation<2>(0)};
        const double distance =
            pairDistance(shapes[i], {centres[i], Rotation<2>(0)}, shapes[j], image).distance;
        ends += distance < 2 * lammpsRounding ? 2 : 0;
    }
    return ends / static_cast<double>(shapes.size());
}

} // namespace chesil::benchmark
