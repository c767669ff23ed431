#include "core/io/worldGrainTable.hpp"

#include "core/shapes/scaledShape.hpp"

#include <map>
#include <set>
#include <utility>

namespace chesil
{

namespace
{

SetupError unknown(const std::string& path, const GrainRow& row, const std::string& found,
                   const std::vector<std::string>& known)
{
    return SetupError(path, "line " + std::to_string(row.line), found, "one of " + listOfNames(known));
}

/// Finds shapes by name and size.
class ShapeFinder
{
public:
    ShapeFinder(std::string path, std::vector<NamedShape>& shapes) : path_(std::move(path)), shapes_(shapes)
    {
        for (std::size_t i = 0; i < shapes.size(); ++i)
        {
            const NamedShape& shape = shapes[i];
            const double size = shape.scaledFrom ? shape.scaledFrom->size : diameterOf(shape.shape);
            const std::string& name = shape.scaledFrom ? shape.scaledFrom->name : shape.name;
            if (!shape.scaledFrom)
            {
                originals_[name] = static_cast<int>(i);
            }
            places_.try_emplace({name, size}, static_cast<int>(i));
        }
    }

    int operator()(const GrainRow& row)
    {
        const auto original = originals_.find(row.shape);
        if (original == originals_.end())
        {
            std::vector<std::string> known;
            for (const auto& [name, place] : originals_)
            {
                known.push_back(name);
            }
            throw unknown(path_, row, "the shape '" + row.shape + "'", known);
        }
        if (!row.size)
        {
            return original->second;
        }
        const auto [place, isNew] =
            places_.try_emplace({row.shape, *row.size}, static_cast<int>(shapes_.size()));
        if (isNew)
        {
            shapes_.push_back(
                scaledFor(row, NamedShape(shapes_[static_cast<std::size_t>(original->second)])));
        }
        return place->second;
    }

private:
    NamedShape scaledFor(const GrainRow& row, const NamedShape& original) const
    {
        try
        {
            return ofSize(original, *row.size);
        }
        catch (const ValueError& error)
        {
            throw error.at(path_, "line " + std::to_string(row.line));
        }
    }

    std::string path_;
    std::vector<NamedShape>& shapes_;
    std::map<std::string, int> originals_;
    /// Of an original's name and a size.
    std::map<std::pair<std::string, double>, int> places_;
};

int materialOf(const std::string& path, const GrainRow& row, const std::vector<Material>& materials)
{
    if (row.material.empty())
    {
        return 0;
    }
    std::vector<std::string> known;
    for (std::size_t i = 0; i < materials.size(); ++i)
    {
        if (materials[i].name == row.material)
        {
            return static_cast<int>(i);
        }
        known.push_back(materials[i].name);
    }
    throw unknown(path, row, "the material '" + row.material + "'", known);
}

} // namespace

std::vector<GrainRow> grainRows(const World& world, const std::vector<GrainState>& start)
{
    const Bodies<2>& bodies = world.bodies();
    std::vector<GrainRow> rows(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const NamedShape& shape = world.settings().shapes[static_cast<std::size_t>(bodies.shape[i])];
        GrainRow& row = rows[i];
        row.shape = shape.scaledFrom ? shape.scaledFrom->name : shape.name;
        row.size = shape.scaledFrom ? shape.scaledFrom->size : world.sizeOf(i);
        row.position = bodies.pose[i].position;
        row.angle = bodies.pose[i].rotation.angle();
        row.velocity = bodies.velocity[i];
        if (world.cell())
        {
            row.velocity -= world.cell()->flow(row.position);
        }
        row.angularVelocity = bodies.angularVelocity[i];
        row.material = world.settings().materials[static_cast<std::size_t>(start[i].material)].name;
        row.driven = start[i].driven;
    }
    return rows;
}

void requireTableNames(const std::vector<NamedShape>& shapes, const std::vector<Material>& materials)
{
    std::set<std::string> names;
    for (const NamedShape& shape : shapes)
    {
        if (shape.scaledFrom)
        {
            continue;
        }
        requireTableName(shape.name);
        if (!names.insert(shape.name).second)
        {
            throw ValueError("two shapes " + shape.name,
                             "a name of its own for each shape, to stand in a table of grains");
        }
    }
    for (const Material& material : materials)
    {
        requireTableName(material.name);
    }
}

std::vector<GrainState> placeGrains(const std::string& path, const std::vector<GrainRow>& rows,
                                    std::vector<NamedShape>& shapes, const std::vector<Material>& materials)
{
    requireTableNames(shapes, materials);
    ShapeFinder shapeOf(path, shapes);
    std::vector<GrainState> grains;
    for (const GrainRow& row : rows)
    {
        GrainState grain;
        grain.shape = shapeOf(row);
        grain.position = row.position;
        grain.angle = row.angle;
        grain.velocity = row.velocity;
        grain.angularVelocity = row.angularVelocity;
        grain.driven = row.driven;
        grain.material = materialOf(path, row, materials);
        grains.push_back(grain);
    }
    return grains;
}

} // namespace chesil
