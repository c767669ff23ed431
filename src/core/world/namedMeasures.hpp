#pragma once

#include "core/world/world.hpp"

#include <string>
#include <vector>

namespace chesil
{

/// A measure that a case can ask for by name: a table with a row a time. doc/cases.md tells what is in it.
struct NamedMeasure
{
    const char* name;
    /// Name and unit of each, as in "mean [Pa]".
    std::vector<std::string> (*columns)(const World&);
    /// As many numbers; nan where there is nothing to measure.
    std::vector<double> (*row)(const World&);
};

/// All there are.
const std::vector<NamedMeasure>& namedMeasures();

std::vector<std::string> measureNames();

/// ValueError for a name that is none of these.
const NamedMeasure& measureNamed(const std::string& name);

} // namespace chesil
