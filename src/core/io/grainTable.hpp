#pragma once

#include "core/base/vector.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace chesil
{

/// One grain of a table. World frame.
struct GrainRow
{
    /// Name of the shape, and diameter of the disk of the same area [m], > 0; none: the shape's own.
    std::string shape;
    std::optional<double> size = std::nullopt;
    /// Centroid [m], angle [rad], velocity [m/s], angular velocity [rad/s].
    Vector2 position = Vector2::Zero();
    double angle = 0;
    Vector2 velocity = Vector2::Zero();
    double angularVelocity = 0;
    /// Empty if it is not told.
    std::string material = {};
    /// Keeps its velocity whatever the forces.
    bool driven = false;
    /// In the file that it was read from, from 1.
    std::size_t line = 0;
};

/// Tables of grains: CSV, a header line of names, then a row a grain, read back to the bit. What follows #
/// and empty lines are passed over.
///
///     shape,size,x,y,angle,vx,vy,angularVelocity,material
///     pebble7,0.012,0.05,0.15,1.2,0,0,0,quartz
///
/// Columns in any order; shape, x and y must be there. A column driven (0 or 1), too, if there are driven
/// grains. Throws SetupError that names file and line for a table without rows, a column that is unknown,
/// twice or missing, a wrong number of fields, a number that is none, a size that is not > 0.
std::vector<GrainRow> readGrainTable(const std::string& path);

/// Columns size and material as the rows have them: all or none. Written aside, then renamed. Throws
/// SetupError if the file cannot be written, and for names that requireTableName refuses.
void writeGrainTable(const std::string& path, const std::vector<GrainRow>& rows);

/// Throws ValueError unless the name of a shape or material is one word without comma, quotes and #.
void requireTableName(const std::string& name);

} // namespace chesil
