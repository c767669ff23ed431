/// The contact kernel on the packing of Lai & Huang, section 5.2: support calls of pairs with and without
/// contact (Fig. 14, Table 1), and the residual of the depth over the iterations of EPA (Fig. 15) and of
/// Newton.

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/paperKernel/callTables.hpp"
#include "benchmarks/paperKernel/packing.hpp"
#include "benchmarks/paperKernel/residualTable.hpp"

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

/// Of the files that go beside the result: its path without the endings.
std::string besideResult;
PackingFiles files;

void reportPacking(const World& world)
{
    double speed = 0;
    for (const Vector2& velocity : world.bodies().velocity)
    {
        speed += velocity.norm() / static_cast<double>(world.bodies().size());
    }
    double touching = 0;
    for (const Contact<2>& contact : world.contacts())
    {
        touching += contact.depth > 0 ? (contact.withWall() ? 1 : 2) : 0;
    }
    std::printf("    %zu grains: mean speed %.1e m/s, kinetic over contact energy %.1e, %.2f contacts a grain, "
                "largest overlap %.1e\n",
                world.bodies().size(), speed,
                kineticEnergy(world.bodies()) / world.contactEnergy(),
                touching / static_cast<double>(world.bodies().size()), world.largestRelativeOverlap());
}

Results measure()
{
    World world(packingSettings(files));
    world.updateForces();
    reportPacking(world);

    const std::vector<NearPair> pairs = nearPairs(world);
    std::vector<PairCalls> calls;
    std::vector<ContactPair> contacts;
    for (const NearPair& pair : pairs)
    {
        calls.push_back(countCalls(pair));
        if (const std::optional<ContactPair> contact = ContactPair::from(pair))
        {
            contacts.push_back(*contact);
        }
    }
    std::printf("    %zu pairs whose bounding circles overlap, %zu in contact\n", pairs.size(),
                contacts.size());

    Results results;
    results.comments = {
        {"title", "Depth of the contacts in a settled packing: EPA and Newton"},
        {"error", "median residual of the depth over the pair's size [-]"},
        {"time", "time of the iterations so far, without GJK [ns]"},
        {"knob", "support calls of A - B"},
        {"size", "sum of the two bounding radii"},
        {"floor", text("residuals below %.2g are rounding and count as that", floorOfResidual)},
        {"packing", text("%zu grains as tutorials/dry/randomPacking leaves them (Lai & Huang, section 5.2)", world.bodies().size())},
        {"clock", text("CPU time, median of %d rounds over all pairs", rounds)},
    };
    writeHistograms(besideResult + "Fig14.csv", calls);
    writePairTypes(besideResult + "Table1.csv", pairs, calls);
    measureResiduals(besideResult + "Fig15.csv", contacts, results);
    return results;
}

std::string withoutEnding(const std::string& path, const std::string& ending)
{
    const bool ends =
        path.size() > ending.size() && path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
    return ends ? path.substr(0, path.size() - ending.size()) : path;
}

} // namespace

/// paperKernel <result> <table of grains> <template file> ...
int main(int argumentCount, char** arguments)
{
    if (argumentCount < 4)
    {
        std::fprintf(stderr, "usage: %s <file to write> <table of grains> <template file> ...\n", arguments[0]);
        return 1;
    }
    besideResult = withoutEnding(withoutEnding(arguments[1], ".part"), ".csv");
    files = {arguments[2], {arguments + 3, arguments + argumentCount}};
    return run(2, arguments, measure);
}
