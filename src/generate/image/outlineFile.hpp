#pragma once

#include "core/base/vector.hpp"

#include <string>
#include <vector>

namespace chesil
{

/// Outlines of grains, counter-clockwise, without a vertex twice, in the file's coordinates, y up.
struct OutlineFile
{
    std::vector<std::vector<Vector2>> outlines;
    /// Of each outline: as in the file, empty if it has none there; and where it stands, for messages.
    std::vector<std::string> names;
    std::vector<std::string> places;
    /// Holes of the polygons, which are not kept.
    int holes = 0;
};

/// A header line with the columns id, x and y, among others maybe, then a row a vertex; the rows of an
/// outline stand together and go around it in either sense, closed or not. What follows # and empty lines are
/// passed over. Throws SetupError that names file and line for a column or number that is missing, an id that
/// comes back after another one, an outline of fewer than three different vertices, of no area, or one that
/// crosses itself.
OutlineFile readCsvOutlines(const std::string& path);

/// The polygons of a GeoJSON file (RFC 7946): FeatureCollection, Feature, Polygon, MultiPolygon; each polygon
/// is a grain. Coordinates are taken as lengths. Its name is the first of the feature's id, properties.name,
/// properties.id that is there, with -1, -2, ... if the feature has several polygons. Throws SetupError that
/// names file and feature for other geometries, a file without polygons, a name that is neither text nor a
/// number, outlines as above, and as parseGeoJson does.
OutlineFile readGeoJsonOutlines(const std::string& path);

/// The outline as OutlineFile has it. Throws ValueError for fewer than three different vertices, no
/// area, or if it crosses itself.
std::vector<Vector2> checkedOutline(std::vector<Vector2> vertices);

} // namespace chesil
