#include "validation/dry/report.hpp"

#include <cstdio>
#include <exception>

namespace
{

using namespace chesil::dry;

void scoreAll(const Report& report)
{
    report.score("impactRestitutionError", "impact", "restitution");
    report.score("impactDurationError", "impact", "duration");
    report.score("obliqueImpactError", "oblique");
    report.score("grazingEnergyGain", "grazing");
    report.score("rollingDistanceError", "rolling", "distance");
    report.score("inclineAccelerationError", "incline", "acceleration");
    report.score("latticeStiffnessError", "lattice");
    report.score("freeSpinError", "free");
    report.score("pileForceError", "pile");
    report.score("bounceHeightError", "bouncing", "height");
    report.score("stackedOscillationError", "bouncing", "stacked");
}

} // namespace

/// Arguments: the files for the table and the points. Exit status 1 if a bound is missed.
int main(int count, char** arguments)
try
{
    if (count != 3)
    {
        std::fprintf(stderr, "Usage: chesilValidation_dry <table.csv> <points.csv>\n");
        return 2;
    }
    Report report;
    for (const auto& oneCase : {impact, obliqueImpact, grazing, rolling, incline, lattice, freeMotion, pile, bouncing})
    {
        oneCase(report);
    }
    report.print();
    report.write(arguments[1], arguments[2]);
    scoreAll(report);
    return report.allWithin() ? 0 : 1;
}
catch (const std::exception& error)
{
    std::fprintf(stderr, "chesilValidation_dry: %s\n", error.what());
    return 2;
}
