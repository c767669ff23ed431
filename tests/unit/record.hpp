#pragma once

#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

namespace chesil::test
{

/// Notes a measured value for the scoreboard (doc/scoreboard.md). Topic, name and unit are those of the
/// bar in tests/bars/<topic>.csv. Does nothing unless tests/Allrun runs the test.
inline void record(const std::string& topic, const std::string& name, double value, const std::string& unit)
{
    const char* file = std::getenv("CHESIL_RECORD");
    if (!file)
    {
        return;
    }
    std::ofstream out(file, std::ios::app);
    out.precision(std::numeric_limits<double>::max_digits10);
    out << topic << ',' << name << ',' << value << ',' << unit << '\n';
}

} // namespace chesil::test
