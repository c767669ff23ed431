#include "core/io/vtkOutput.hpp"

#include "core/base/setupError.hpp"
#include "core/io/fileAside.hpp"
#include "core/measure/measuredContact.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <set>
#include <ostream>

namespace chesil
{

namespace
{

/// Chords leave the true outline by at most this share of a grain's size: a fifth of a pixel when the grain fills a
/// screen of 1000 pixels.
constexpr double outlineTolerance = 2e-4;

struct Polyline
{
    std::vector<Vector2> points;
};

/// A named array with one number a cell.
struct CellArray
{
    std::string name;
    std::function<double(std::size_t)> value;
};

void writePolyData(std::ostream& file, const char* kind, const std::vector<Polyline>& cells, const std::vector<CellArray>& arrays)
{
    std::size_t points = 0;
    for (const Polyline& cell : cells)
    {
        points += cell.points.size();
    }
    const bool polygons = std::string(kind) == "Polys";
    file << "<?xml version=\"1.0\"?>\n"
         << "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n"
         << "<Piece NumberOfPoints=\"" << points << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << (polygons ? 0 : cells.size())
         << "\" NumberOfStrips=\"0\" NumberOfPolys=\"" << (polygons ? cells.size() : 0) << "\">\n";

    file.precision(9);
    file << "<CellData>\n";
    for (const CellArray& array : arrays)
    {
        file << "<DataArray type=\"Float64\" Name=\"" << array.name << "\" format=\"ascii\">\n";
        for (std::size_t i = 0; i < cells.size(); ++i)
        {
            file << array.value(i) << '\n';
        }
        file << "</DataArray>\n";
    }
    file << "</CellData>\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    for (const Polyline& cell : cells)
    {
        for (const Vector2& point : cell.points)
        {
            file << point.x() << ' ' << point.y() << " 0\n";
        }
    }
    file << "</DataArray>\n</Points>\n<" << kind << ">\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
    for (std::size_t i = 0; i < points; ++i)
    {
        file << i << '\n';
    }
    file << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
    std::size_t offset = 0;
    for (const Polyline& cell : cells)
    {
        offset += cell.points.size();
        file << offset << '\n';
    }
    file << "</DataArray>\n</" << kind << ">\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

/// The part of a wall inside all other walls; where none bounds it, as long as the grains' extent along it.
Polyline visiblePart(const PlaneWall<2>& wall, const World& world)
{
    if (wall.plate)
    {
        return {{wall.point - wall.plate->half, wall.point + wall.plate->half}};
    }
    const Vector2 tangent = perpendicular(wall.normal);
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    for (const PlaneWall<2>& other : world.walls())
    {
        const double slope = tangent.dot(other.normal);
        if (&other != &wall && !other.plate && slope != 0)
        {
            const double crossing = -other.distance(wall.point) / slope;
            (slope > 0 ? from : to) = slope > 0 ? std::max(from, crossing) : std::min(to, crossing);
        }
    }

    double lowest = 0;
    double highest = 0;
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
        const double along = tangent.dot(world.bodies().pose[i].position - wall.point);
        lowest = std::min(lowest, along - world.bodies().boundingRadius[i]);
        highest = std::max(highest, along + world.bodies().boundingRadius[i]);
    }
    from = std::isfinite(from) ? from : lowest;
    to = std::isfinite(to) ? to : highest;
    return {{wall.point + from * tangent, wall.point + to * tangent}};
}

/// Closed; of a strip a line across it.
Polyline outlineOf(const PeriodicCell& cell)
{
    const Vector2& corner = cell.lower();
    const Vector2 right = corner + cell.first();
    const Vector2 above = corner + cell.second();
    return {{corner, right, right + cell.second(), above, corner}};
}

} // namespace

std::string VtkOutput::nameOf(std::size_t index, const char* what)
{
    char name[64];
    std::snprintf(name, sizeof name, "grains/%s_%06zu.vtp", what, index);
    return name;
}

std::vector<double> VtkOutput::times() const
{
    std::vector<double> result;
    for (const auto& [time, name] : written_)
    {
        result.push_back(time);
    }
    return result;
}

VtkOutput::VtkOutput(std::string caseFolder, const World& world, const std::vector<double>& times, bool withContacts)
: caseFolder_(std::move(caseFolder)), withContacts_(withContacts)
{
    std::set<std::string> kept;
    for (const double time : times)
    {
        kept.insert(nameOf(written_.size(), "contacts"));
        written_.emplace_back(time, nameOf(written_.size()));
        kept.insert(written_.back().second);
    }
    const std::string folder = caseFolder_ + "/grains";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    // The user may keep other files beside ours.
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    {
        const std::string file = entry->path().filename().string();
        const bool ours = file.rfind("grains_", 0) == 0 || file.rfind("contacts_", 0) == 0;
        if (ours && entry->path().extension() == ".vtp" && kept.count("grains/" + file) == 0)
        {
            std::filesystem::remove(entry->path(), error);
        }
    }
    if (error)
    {
        throw SetupError(folder, "(whole folder)", error.message(), "a folder that can be written to");
    }
    writeWalls(world);
}

void VtkOutput::writeWalls(const World& world) const
{
    std::vector<Polyline> walls;
    for (const PlaneWall<2>& wall : world.walls())
    {
        walls.push_back(visiblePart(wall, world));
    }
    if (world.cell())
    {
        walls.push_back(outlineOf(world.cell()->cell));
    }
    writeAside(caseFolder_ + "/grains/walls.vtp", [&](std::ostream& file) { writePolyData(file, "Lines", walls, {}); });
}

void VtkOutput::writeContacts(const World& world) const
{
    std::vector<const Contact<2>*> touching;
    std::vector<Polyline> lines;
    for (const Contact<2>& contact : world.contacts())
    {
        if (contact.depth > 0)
        {
            const Vector2& from = world.bodies().pose[static_cast<std::size_t>(contact.first)].position;
            touching.push_back(&contact);
            lines.push_back({{from, from + world.branchOf(contact)}});
        }
    }
    const std::vector<CellArray> arrays{
        {"normalForce", [&](std::size_t i) { return normalForce(*touching[i]); }},
        {"tangentialForce", [&](std::size_t i) { return tangentialForce(*touching[i]); }},
        {"overlap", [&](std::size_t i) { return touching[i]->depth; }},
        {"first", [&](std::size_t i) { return static_cast<double>(touching[i]->first); }},
        {"second", [&](std::size_t i) { return static_cast<double>(touching[i]->second); }},
    };
    writeAside(caseFolder_ + "/" + nameOf(written_.size(), "contacts"),
        [&](std::ostream& file) { writePolyData(file, "Lines", lines, arrays); });
}

void VtkOutput::write(const World& world, double time)
{
    const Bodies<2>& bodies = world.bodies();
    std::vector<Polyline> grains;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const Outline boundary = placed(outline(world.shapeOf(i)), bodies.pose[i]);
        grains.push_back({outlinePoints(boundary, outlineTolerance * world.sizeOf(i))});
    }
    const std::vector<CellArray> arrays{
        {"id", [](std::size_t i) { return static_cast<double>(i); }},
        {"shape", [&](std::size_t i) { return static_cast<double>(bodies.shape[i]); }},
        {"kind", [&](std::size_t i) { return static_cast<double>(world.shapeOf(i).index()); }},
        {"size", [&](std::size_t i) { return world.sizeOf(i); }},
        {"angle", [&](std::size_t i) { return bodies.pose[i].rotation.angle(); }},
        {"speed", [&](std::size_t i) { return bodies.velocity[i].norm(); }},
        {"angularVelocity", [&](std::size_t i) { return bodies.angularVelocity[i]; }},
    };

    const std::string name = nameOf(written_.size());
    writeAside(caseFolder_ + "/" + name, [&](std::ostream& file) { writePolyData(file, "Polys", grains, arrays); });
    if (withContacts_)
    {
        writeContacts(world);
    }
    const auto movesAtAll = [](const PlaneWall<2>& wall) { return moves(wall.motion); };
    const bool strained = world.cell() && world.cell()->isStrained();
    if (strained || std::any_of(world.walls().begin(), world.walls().end(), movesAtAll))
    {
        writeWalls(world);
    }
    written_.emplace_back(time, name);
    writeIndex();
}

void VtkOutput::writeIndex() const
{
    writeAside(
        caseFolder_ + "/grains.pvd",
        [&](std::ostream& file)
        {
            file.precision(12);
            file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
            for (const auto& [time, name] : written_)
            {
                file << "<DataSet timestep=\"" << time << "\" part=\"0\" file=\"" << name << "\"/>\n";
            }
            file << "</Collection>\n</VTKFile>\n";
        });
}

} // namespace chesil
