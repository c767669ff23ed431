/*---------------------------------------------------------------------------*\
    Chesil: smooth irregular grains, dry and in OpenFOAM flow
    Licence: GPL-3.0-or-later, see LICENSE
-------------------------------------------------------------------------------
Application
    chesilFit

Group
    grpChesil

Description
    Makes templates of smooth convex grains from an image of grains or from
    their outlines. Needs no case.

    Writes a template file (doc/templateFile.md) with one polybezier grain for
    each whole grain of the image, turned as in the image. Outlines keep their
    names, grains of images are called grain1, grain2, ... The file's ending
    tells what is read (doc/grainFit.md): .csv and .geojson or .json outlines,
    everything else an image, PNG, JPEG or TIFF.

Usage
    \b chesilFit [OPTION] image

    Options:
      - \par -segments \<number\>
        Bezier segments of each grain, or sides of each polygon, default: 10;
        with -accuracy: at most, default: 64

      - \par -accuracy \<share\>
        Wanted accuracy against the convex hull, 0 to 1: segments are added
        where the error is until it is reached

      - \par -model \<polybezier|polygon|ellipse\>
        Shape of the grains, default: polybezier

      - \par -method \<direct|swarm\>
        Gauss-Newton on all numbers at once, or Lai & Huang's particle swarm,
        default: direct

      - \par -joints \<adapted|equal\>
        Joints where the outline needs them, or at equally spaced normals (as
        the swarm has them), default: adapted

      - \par -particles \<number\>
        Of the swarm, default: 20

      - \par -iterations \<number\>
        Of the swarm, default: 50

      - \par -seed \<number\>
        Of the swarm's random numbers, default: 1

      - \par -scale \<metres\>
        Size of a pixel [m]; without it sizes are in pixels, and the file says so

      - \par -output \<file\>
        The template file, default: grains.chesil

      - \par -report \<file\>
        Table (CSV) of accuracy and time, one row a grain

      - \par -placement \<file\>
        Table (CSV) of each grain's centroid in the image and, of ellipses, the
        angle

      - \par -minPixels \<number\>
        Grains of fewer pixels are dropped as specks, default: 200

      - \par -threshold \<grey\>
        Grey values (0 black to 255 white) up to this one are grain,
        default: Otsu's choice

      - \par -light
        Light grains on a dark ground: the grey values above are grain

      - \par -split
        Cut grains apart that seem to touch; without it they are named only

      - \par -labels
        The image has a value of its own for each grain

      - \par -ground \<value\>
        The ground's value in a label image, default: 0

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "clockTime.H"
#include "fitOptions.H"
#include "imageOptions.H"

#include "core/io/templateFile.hpp"
#include "generate/fit/fitTables.hpp"
#include "generate/image/imageSummary.hpp"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

static void declareOptions()
{
    argList::noBanner();
    argList::noFunctionObjects();
    argList::noJobInfo();
    argList::noParallel();
    argList::removeOption("case");
    argList::addNote
    (
        "Make templates of smooth convex grains from an image of grains or"
        " from their outlines"
    );
    argList::addArgument
    (
        "image",
        "By its ending: outlines (.csv with the columns id, x, y; .geojson or"
        " .json), else an image (PNG, JPEG or TIFF, colour or grey)"
    );
    declareFitOptions();
    argList::addOption
    (
        "scale", "metres", "Size of a pixel (default: none, sizes in pixels)"
    );
    argList::addOption
    (
        "output", "file", "The template file (default: grains.chesil)"
    );
    argList::addOption
    (
        "report", "file", "Table (CSV) of accuracy and time, one row a grain"
    );
    argList::addOption
    (
        "placement", "file", "Table (CSV) of each grain's centroid in the image"
    );
    declareImageOptions();
}


static void printMedian
(
    const char* title,
    const std::vector<chesil::GrainFit>& fits,
    double chesil::GrainFit::*member
)
{
    std::vector<double> values;
    for (const chesil::GrainFit& fit : fits)
    {
        values.push_back(fit.*member);
    }
    std::sort(values.begin(), values.end());
    Info<< title << "median " << values[values.size()/2]
        << ", least " << values.front()
        << ", largest " << values.back() << endl;
}


//- The grains, if any, that are less accurate than wanted
static void printUnreached(const std::vector<chesil::GrainFit>& fits)
{
    std::string names;
    int count = 0;
    for (const chesil::GrainFit& fit : fits)
    {
        if (!fit.reachedAccuracy)
        {
            names += (count++ ? " " : "") + fit.name;
        }
    }
    if (count)
    {
        Info<< "Note: " << count << " grains did not reach the wanted accuracy"
            << " with the segments allowed: " << names.c_str() << endl;
    }
}


static void printSummary
(
    const chesil::ImageGrains& image,
    const std::vector<chesil::GrainFit>& fits,
    const chesil::ImageSettings& settings
)
{
    Info<< "Grains found              " << label(fits.size()) << nl
        << chesil::imageFindings(image, settings).c_str();

    printMedian("Accuracy to silhouette    ", fits, &chesil::GrainFit::accuracySilhouette);
    printMedian("Accuracy to convex hull   ", fits, &chesil::GrainFit::accuracyHull);
    printMedian("Milliseconds a grain      ", fits, &chesil::GrainFit::milliseconds);
    printUnreached(fits);
}


static void run(const argList& args)
{
    const clockTime timer;
    const fileName path = args.get<fileName>(1);

    const chesil::ImageSettings imageSettings = readImageSettings(args);
    chesil::FitSettings fitSettings = readFitSettings(args);
    readNumber(args, "scale", fitSettings.scale);

    const chesil::ImageGrains image = chesil::readGrains(path, imageSettings);
    Info<< chesil::imageTitle(path, image, imageSettings).c_str() << endl;
    fitSettings.scale *= image.pixelSize;
    const std::vector<chesil::GrainFit> fits =
        chesil::fitGrains(path, image, fitSettings);

    chesil::TemplateFile templates;
    templates.unit = args.found("scale") ? "m" : "pixel";
    for (const chesil::GrainFit& fit : fits)
    {
        templates.grains.push_back({fit.name, fit.grain});
    }
    fileName output("grains.chesil");
    args.readIfPresent("output", output);
    chesil::writeTemplates(output, templates);
    fileName table;
    if (args.readIfPresent("report", table))
    {
        chesil::writeFitReport(table, fits);
    }
    if (args.readIfPresent("placement", table))
    {
        chesil::writePlacement(table, fits);
    }

    printSummary(image, fits, imageSettings);
    Info<< "Templates                 " << output.c_str() << " (unit "
        << templates.unit.c_str() << ")" << nl
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
        std::cerr << "chesilFit: " << problem.what() << std::endl;
        // The end of argList would make the exit status 0
        std::exit(1);
    }
    return 0;
}


// ************************************************************************* //
