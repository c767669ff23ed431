#pragma once

#include "core/shapes/shape.hpp"

#include <string>
#include <vector>

namespace chesil
{

/// Template files: text, one file for many grains, read back to the bit. Layout (doc/templateFile.md):
///
///     chesilTemplates 1
///     unit m                    # m, or pixel if the size of a pixel was not known
///     count 2
///     grain pebble7 polybezier 10
///     x0 y0 x1 y1 x2 y2         # P0 Q1 Q2 of each segment; its end is the next one's P0
///     ...
///     grain tile polygon 4
///     x y                       # a vertex a line, counter-clockwise
///     ...
///     grain ball circle 0.01    # radius
///     grain egg ellipse 0.01 0.008
///     end
///
/// Everything after # is a comment.
struct TemplateFile
{
    std::string unit = "m";
    std::vector<NamedShape> grains;
};

/// Throws SetupError that names the file and the line if it is missing, cut short, or holds a grain
/// that is not finite, not convex, crosses itself or has an unknown type.
TemplateFile readTemplates(const std::string& path);

/// Written aside, then renamed, so that an interrupted run leaves no half file. Throws SetupError if the
/// file cannot be written.
void writeTemplates(const std::string& path, const TemplateFile& templates);

} // namespace chesil
