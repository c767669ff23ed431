#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace chesil
{

/// Gets a feature, or all of a file that is no FeatureCollection; its place is for messages: "feature 3".
using TakeFeature = std::function<void(const nlohmann::json&, const std::string& place)>;

/// Reads a GeoJSON file. Of a FeatureCollection, `take` gets each feature when it has been read, and forgets
/// it before the next is. Throws SetupError if the file cannot be read or is no JSON (names the line), if
/// lists and objects stand more than deepestJson within each other, a member stands twice, or a number is too
/// large (names the feature), and adds file and feature to a ValueError of `take`.
void parseGeoJson(const std::string& path, const TakeFeature& take);

/// Features hold their coordinates seven deep; what properties hold is not read.
constexpr int deepestJson = 100;

constexpr const char* expectedPolygons = "features that are Polygon or MultiPolygon";

} // namespace chesil
