/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    chesilDescribe

Group
    grpChesil

Description
    Describes the shapes of grains: elongation, roundness, circularity,
    sphericity, convexity, regularity, size and Fourier spectrum. Needs no
    case.

    The file's ending tells what is described (doc/grainDescriptors.md):
    .chesil templates, .csv and .geojson or .json outlines, everything else an
    image, PNG, JPEG or TIFF.

Usage
    \b chesilDescribe [OPTION] file

    Options:
      - \par -scale \<metres\>
        Size of a pixel [m]; without it sizes are in pixels, and the table says
        so. Templates have a unit of their own

      - \par -output \<file\>
        Table (CSV), one row a grain, default: descriptors.csv

      - \par -spectrum \<file\>
        Table (CSV) of the normalised amplitudes D_0 to D_64, one row a grain

      - \par -outlines \<file\>
        Table (CSV) of the outlines as they were described, for pictures

      - \par -minPixels, -threshold, -light, -split, -labels, -ground
        As those of chesilFit

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "clockTime.H"
#include "imageOptions.H"

#include "generate/descriptors/describedGrains.hpp"
#include "generate/image/imageSummary.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- Grains and the unit of their lengths
struct Described
{
    std::vector<chesil::DescribedGrain> grains;
    std::string unit;
};


static void declareOptions()
{
    argList::noBanner();
    argList::noFunctionObjects();
    argList::noJobInfo();
    argList::noParallel();
    argList::removeOption("case");
    argList::addNote
    (
        "Describe the shapes of grains in an image, of outlines or of templates"
    );
    argList::addArgument
    (
        "file",
        "By its ending: templates (.chesil), outlines (.csv with the columns id,"
        " x, y; .geojson or .json), else an image (PNG, JPEG or TIFF)"
    );
    argList::addOption
    (
        "scale", "metres", "Size of a pixel (default: none, sizes in pixels)"
    );
    argList::addOption
    (
        "output", "file", "Table (CSV), one row a grain (default: descriptors.csv)"
    );
    argList::addOption
    (
        "spectrum", "file", "Table (CSV) of Fourier amplitudes, one row a grain"
    );
    argList::addOption
    (
        "outlines", "file", "Table (CSV) of the outlines that were described"
    );
    declareImageOptions();
}


static Described describeTemplates(const argList& args, const fileName& path)
{
    for
    (
        const char* option
      : {"scale", "minPixels", "threshold", "light", "split", "labels", "ground"}
    )
    {
        if (args.found(option))
        {
            throw chesil::SetupError
            (
                "(command line)", std::string("-") + option, path,
                "an image or outlines; templates have a unit and an outline of"
                " their own"
            );
        }
    }
    const chesil::TemplateFile templates = chesil::readTemplates(path);
    Info<< "Templates                 " << path.c_str() << endl;
    return {chesil::describeGrains(templates), templates.unit};
}


static Described describeImage(const argList& args, const fileName& path)
{
    const chesil::ImageSettings settings = readImageSettings(args);
    double scale = 1;
    if (readNumber(args, "scale", scale) && !(scale > 0))
    {
        throw chesil::SetupError("(command line)", "-scale", args["scale"], "a size above 0");
    }
    const chesil::ImageGrains image = chesil::readGrains(path, settings);
    Info<< chesil::imageTitle(path, image, settings).c_str() << nl
        << chesil::imageFindings(image, settings).c_str();
    return
    {
        chesil::describeGrains(image, scale*image.pixelSize),
        args.found("scale") ? "m" : "pixel"
    };
}


static void printMedian
(
    const char* title,
    const std::vector<chesil::DescribedGrain>& grains,
    double chesil::ShapeDescriptors::*member
)
{
    std::vector<double> values;
    for (const chesil::DescribedGrain& grain : grains)
    {
        values.push_back(grain.shape.*member);
    }
    std::sort(values.begin(), values.end());
    Info<< title << "median " << values[values.size()/2]
        << ", least " << values.front()
        << ", largest " << values.back() << endl;
}


static void printSummary(const Described& described)
{
    using Shape = chesil::ShapeDescriptors;
    Info<< "Grains described          " << label(described.grains.size()) << endl;
    printMedian("Equivalent diameter       ", described.grains, &Shape::equivalentDiameter);
    printMedian("Elongation                ", described.grains, &Shape::elongation);
    printMedian("Roundness                 ", described.grains, &Shape::roundness);
    printMedian("Roundness of corners      ", described.grains, &Shape::cornerRoundness);
    printMedian("Circularity               ", described.grains, &Shape::circularity);
    printMedian("Sphericity                ", described.grains, &Shape::sphericity);
    printMedian("Convexity                 ", described.grains, &Shape::convexity);
    const auto open = std::count_if
    (
        described.grains.begin(),
        described.grains.end(),
        [](const chesil::DescribedGrain& grain) { return !grain.shape.spectrum; }
    );
    if (open)
    {
        Info<< "Note: " << label(open) << " grains are not star-shaped about"
            << " their centroids and have no spectrum" << endl;
    }
}


static void run(const argList& args)
{
    const clockTime timer;
    const fileName path = args.get<fileName>(1);
    const Described described =
        path.hasExt("chesil") ? describeTemplates(args, path) : describeImage(args, path);

    fileName output("descriptors.csv");
    args.readIfPresent("output", output);
    chesil::writeDescriptors(output, described.grains, described.unit);
    fileName table;
    if (args.readIfPresent("spectrum", table))
    {
        chesil::writeSpectra(table, described.grains);
    }
    if (args.readIfPresent("outlines", table))
    {
        chesil::writeOutlines(table, described.grains);
    }
    printSummary(described);
    Info<< "Table                     " << output.c_str() << " (unit "
        << described.unit.c_str() << ")" << nl
        << "Time                      " << timer.elapsedTime() << " s" << endl;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    declareOptions();
    const argList args(argc, argv);
    try
    {
        run(args);
    }
    catch (const std::exception& problem)
    {
        std::cerr << "chesilDescribe: " << problem.what() << std::endl;
        // The end of argList would make the exit status 0
        std::exit(1);
    }
    return 0;
}


// ************************************************************************* //
