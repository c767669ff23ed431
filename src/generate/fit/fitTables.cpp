#include "generate/fit/fitTables.hpp"

#include "core/io/fileAside.hpp"

#include <iomanip>

namespace chesil
{

namespace
{

template <class WriteRow>
void writeTable(const std::string& path, const char* header, const std::vector<GrainFit>& fits,
                const WriteRow& writeRow)
{
    writeAside(path,
               [&](std::ostream& file)
               {
                   file << header << '\n';
                   for (const GrainFit& fit : fits)
                   {
                       file << fit.name << ',';
                       writeRow(file, fit);
                       file << '\n';
                   }
               });
}

} // namespace

void writeFitReport(const std::string& path, const std::vector<GrainFit>& fits)
{
    writeTable(path, "id,pixels,accuracySilhouette,accuracyHull,segments,milliseconds", fits,
               [](std::ostream& row, const GrainFit& fit)
               {
                   row << fit.pixels << ',' << fit.accuracySilhouette << ',' << fit.accuracyHull << ','
                       << fit.segments << ',' << fit.milliseconds;
               });
}

void writePlacement(const std::string& path, const std::vector<GrainFit>& fits)
{
    writeTable(path, "id,x,y,angle", fits,
               [](std::ostream& row, const GrainFit& fit) {
                   row << std::setprecision(17) << fit.centroid.x() << ',' << fit.centroid.y() << ','
                       << fit.angle;
               });
}

} // namespace chesil
