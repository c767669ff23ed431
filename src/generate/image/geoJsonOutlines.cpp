#include "core/base/setupError.hpp"
#include "generate/image/outlineFile.hpp"

// Boost 1.74 itself uses what it warns about
#define BOOST_BIND_GLOBAL_PLACEHOLDERS
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

namespace chesil
{

namespace
{

using Json = boost::property_tree::ptree;

constexpr const char* expectedPolygons = "features that are Polygon or MultiPolygon";

double coordinate(const Json& value)
{
    const std::string& text = value.data();
    double number = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (problem != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
    {
        throw ValueError("the coordinate '" + text + "'", "a number");
    }
    return number;
}

std::vector<Vector2> readRing(const Json& ring)
{
    std::vector<Vector2> vertices;
    for (const auto& [name, position] : ring)
    {
        if (position.size() < 2)
        {
            throw ValueError("a position of " + std::to_string(position.size()) + " numbers", "at least 2");
        }
        auto number = position.begin();
        const double x = coordinate(number->second);
        const double y = coordinate((++number)->second);
        vertices.emplace_back(x, y);
    }
    return vertices;
}

void addPolygon(const Json& rings, OutlineFile& file)
{
    if (rings.empty())
    {
        throw ValueError("a polygon without points", "an outline");
    }
    file.outlines.push_back(checkedOutline(readRing(rings.front().second)));
    file.holes += static_cast<int>(rings.size()) - 1;
}

void addGeometry(const Json& geometry, OutlineFile& file)
{
    const std::string type = geometry.get("type", "no geometry");
    static const Json none;
    const Json& coordinates = geometry.get_child("coordinates", none);
    if (type == "Polygon")
    {
        addPolygon(coordinates, file);
    }
    else if (type == "MultiPolygon")
    {
        for (const auto& [name, rings] : coordinates)
        {
            addPolygon(rings, file);
        }
    }
    else
    {
        throw ValueError(type, expectedPolygons);
    }
}

Json readJson(const std::string& path)
{
    errno = 0;
    std::ifstream stream(path);
    if (!stream.good() || stream.peek() == std::ifstream::traits_type::eof())
    {
        throw SetupError(path, "GeoJSON", errno != 0 ? std::strerror(errno) : "an empty file",
                         "a GeoJSON file that can be read");
    }
    Json json;
    try
    {
        boost::property_tree::read_json(stream, json);
    }
    catch (const boost::property_tree::json_parser_error& error)
    {
        throw SetupError(path, "line " + std::to_string(error.line()), error.message(),
                         "whole GeoJSON with " + std::string(expectedPolygons));
    }
    return json;
}

} // namespace

OutlineFile readGeoJsonOutlines(const std::string& path)
{
    const Json json = readJson(path);
    OutlineFile file;
    std::string entry = "geometry";
    try
    {
        const std::string type = json.get("type", "");
        if (type == "FeatureCollection")
        {
            static const Json none;
            std::size_t number = 0;
            for (const auto& [name, feature] : json.get_child("features", none))
            {
                entry = "feature " + std::to_string(++number);
                addGeometry(feature.get_child("geometry", none), file);
            }
            entry = "features";
        }
        else
        {
            static const Json none;
            addGeometry(type == "Feature" ? json.get_child("geometry", none) : json, file);
        }
        if (file.outlines.empty())
        {
            throw ValueError("no polygon", expectedPolygons);
        }
    }
    catch (const ValueError& error)
    {
        throw error.at(path, entry);
    }
    return file;
}

} // namespace chesil
