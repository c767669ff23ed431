/// What the throughput of dry flows is measured with, for `race` (see Allrun):
///     -pack <folder>           writes all scenes for all codes
///     -serve <code> <scene>    runs as many steps of the scene as each line of the standard input says and
///     answers
///                              "done"; at its end says the contacts a grain. Codes: chesil, box2d
///     -contacts <dump>         says the contacts a grain of polygons that LAMMPS has dumped

#include "benchmarks/dryThroughput/box2dBox.hpp"
#include "benchmarks/dryThroughput/lammpsContacts.hpp"
#include "benchmarks/dryThroughput/packing.hpp"

#include <iostream>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

/// Grains of the cell that is repeated, and repeats along both vectors for 2,000, 20,000 and 200,000 grains.
constexpr int cellGrains = 2000;
constexpr std::array<std::array<int, 2>, 3> repeats = {{{1, 1}, {5, 2}, {10, 10}}};
/// Of walls around a packing cut out of a cell [m].
constexpr double wallMargin = 0.05;

void packDisks(const std::string& folder)
{
    const Scene cell = flowingCell(Grains::disks, cellGrains, diskFraction);
    for (const auto& [along, up] : repeats)
    {
        const Scene scene = tiled(cell, along, up, Numbering::byPlace);
        const std::string path = text("%s/disks%zu", folder.c_str(), scene.grains.size());
        writeScene(scene, path + ".scene");
        writeLammpsDisks(scene, path + ".data");
    }
}

void packPolyBeziers(const std::string& folder)
{
    const Scene cell = flowingCell(Grains::polyBeziers, cellGrains, polyBezierFraction);
    for (const auto& [along, up] : {repeats[0], repeats[1]})
    {
        const Scene scene = tiled(cell, along, up, Numbering::byPlace);
        const std::string path = text("%s/polyBeziers%zu", folder.c_str(), scene.grains.size());
        writeScene(scene, path + ".scene");
        writeScene(boxed(scene, wallMargin), path + "Box.scene");
    }
}

void packPolygons(const std::string& folder)
{
    const Scene cell = flowingCell(Grains::polygons, cellGrains, polygonFraction);
    for (const auto& [along, up] : {repeats[0], repeats[1]})
    {
        const Scene scene = tiled(cell, along, up, Numbering::byPlace);
        const std::string path = text("%s/polygons%zu", folder.c_str(), scene.grains.size());
        writeScene(scene, path + ".scene");
        writeLammpsPolygons(scene, path + ".data");
    }
}

template <class Run, class Contacts>
void answer(const Run& run, const Contacts& contacts)
{
    for (int steps = 0; std::cin >> steps;)
    {
        run(steps);
        std::puts("done");
        std::fflush(stdout);
    }
    std::printf("%.6g\n", contacts());
}

void serve(const std::string& code, const std::string& path)
{
    if (code == "box2d")
    {
        Box2dBox box(readScene(path));
        answer([&](int steps) { box.run(steps); }, [&] { return box.contactsAGrain(); });
        return;
    }
    World world(settingsOf(readScene(path)));
    world.updateForces();
    answer([&](int steps) { runSteps(world, sceneTimeStep, steps); }, [&] { return contactsAGrain(world); });
}

} // namespace

int main(int argumentCount, char** arguments)
{
    const std::vector<std::string> words(arguments + 1, arguments + argumentCount);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    try
    {
        if (words.size() == 2 && words[0] == "-pack")
        {
            packDisks(words[1]);
            packPolyBeziers(words[1]);
            packPolygons(words[1]);
        }
        else if (words.size() == 3 && words[0] == "-serve")
        {
            serve(words[1], words[2]);
        }
        else if (words.size() == 2 && words[0] == "-contacts")
        {
            std::printf("%.6g\n", contactsAGrain(readDump(words[1])));
        }
        else
        {
            std::fprintf(stderr, "usage: -pack <folder> | -serve <code> <scene> | -contacts <dump>\n");
            return 1;
        }
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s: %s\n", arguments[0], error.what());
        return 1;
    }
    return 0;
}
