#include "core/base/setupError.hpp"
#include "generate/image/geoJsonParser.hpp"
#include "generate/image/outlineFile.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace chesil
{

namespace
{

using Json = nlohmann::json;

/// Null if the object has no such member, or is no object.
const Json& member(const Json& object, const char* name)
{
    static const Json none;
    const auto found = object.is_object() ? object.find(name) : object.end();
    return found == object.end() ? none : *found;
}

double coordinate(const Json& value)
{
    if (!value.is_number() || !std::isfinite(value.get<double>()))
    {
        throw ValueError("the coordinate '" + (value.is_string() ? value.get<std::string>() : value.dump()) +
                             "'",
                         "a number");
    }
    return value.get<double>();
}

std::vector<Vector2> readRing(const Json& ring)
{
    std::vector<Vector2> vertices;
    for (const Json& position : ring)
    {
        if (!position.is_array() || position.size() < 2)
        {
            throw ValueError("a position of " + std::to_string(position.is_array() ? position.size() : 0) +
                                 " numbers",
                             "at least 2");
        }
        vertices.emplace_back(coordinate(position[0]), coordinate(position[1]));
    }
    return vertices;
}

/// The outlines of a geometry; adds their holes to those of the file.
std::vector<std::vector<Vector2>> readPolygon(const Json& rings, OutlineFile& file)
{
    if (!rings.is_array() || rings.empty())
    {
        throw ValueError("a polygon without points", "an outline");
    }
    file.holes += static_cast<int>(rings.size()) - 1;
    return {checkedOutline(readRing(rings.front()))};
}

std::vector<std::vector<Vector2>> readGeometry(const Json& geometry, OutlineFile& file)
{
    const Json& coordinates = member(geometry, "coordinates");
    const Json& type = member(geometry, "type");
    if (type == "Polygon")
    {
        return readPolygon(coordinates, file);
    }
    if (type != "MultiPolygon")
    {
        throw ValueError(type.is_string() ? type.get<std::string>() : "no geometry", expectedPolygons);
    }
    if (coordinates.empty())
    {
        throw ValueError("a MultiPolygon without polygons", "an outline");
    }
    std::vector<std::vector<Vector2>> outlines;
    for (const Json& rings : coordinates)
    {
        outlines.push_back(readPolygon(rings, file).front());
    }
    return outlines;
}

/// Text or a number; empty if there is none.
std::string nameOf(const Json& feature)
{
    const Json& properties = member(feature, "properties");
    for (const Json* value : {&member(feature, "id"), &member(properties, "name"), &member(properties, "id")})
    {
        if (value->is_string())
        {
            return value->get<std::string>();
        }
        if (value->is_number())
        {
            return value->dump();
        }
        if (!value->is_null())
        {
            throw ValueError("the name " + value->dump(), "text or a number");
        }
    }
    return "";
}

} // namespace

OutlineFile readGeoJsonOutlines(const std::string& path)
{
    OutlineFile file;
    parseGeoJson(path,
                 [&](const Json& json, const std::string& place)
                 {
                     const bool isFeature = json.is_object() && json.contains("geometry");
                     const std::string name = isFeature ? nameOf(json) : "";
                     auto outlines = readGeometry(isFeature ? json["geometry"] : json, file);
                     for (std::size_t i = 0; i < outlines.size(); ++i)
                     {
                         const bool numbered = !name.empty() && outlines.size() > 1;
                         file.names.push_back(numbered ? name + "-" + std::to_string(i + 1) : name);
                         file.places.push_back(place);
                         file.outlines.push_back(std::move(outlines[i]));
                     }
                 });
    if (file.outlines.empty())
    {
        throw SetupError(path, "features", "no polygon", expectedPolygons);
    }
    return file;
}

} // namespace chesil
