#include "generate/descriptors/describedGrains.hpp"

#include "core/geometry/outline.hpp"
#include "core/io/fileAside.hpp"

#include <iomanip>

namespace chesil
{

namespace
{

/// Chords of a template's outline in a table, over its radius: not seen in a picture.
constexpr double drawnTolerance = 1e-3;

void writeRow(std::ostream& file, const ShapeDescriptors& shape)
{
    for (const double value :
         {shape.equivalentDiameter, shape.area, shape.perimeter, shape.elongation, shape.elongationAngle, shape.roundness,
          shape.cornerRoundness, shape.circularity, shape.sphericity, shape.convexity, shape.regularity})
    {
        file << ',' << value;
    }
    for (const OutlineCircle& circle : {shape.inscribed, shape.circumscribed})
    {
        file << ',' << circle.centre.x() << ',' << circle.centre.y() << ',' << circle.radius;
    }
}

} // namespace

std::vector<DescribedGrain> describeGrains(const ImageGrains& image, double scale)
{
    std::vector<DescribedGrain> described;
    described.reserve(image.grains.size());
    for (std::size_t i = 0; i < image.grains.size(); ++i)
    {
        const Silhouette& silhouette = image.grains[i];
        ClosedOutline outline = outlineToDescribe(silhouette);
        for (Vector2& point : outline)
        {
            point = scale * (point + silhouette.corner());
        }
        const EdgeAccuracy accuracy = edgeAccuracy(silhouette);
        const ShapeDescriptors shape = describePixels(outline, accuracy, scale);
        described.push_back(
            {image.name(i), accuracy == EdgeAccuracy::pixel ? "pixel" : "sub-pixel", std::move(outline), shape});
    }
    return described;
}

std::vector<DescribedGrain> describeGrains(const TemplateFile& templates)
{
    std::vector<DescribedGrain> described;
    described.reserve(templates.grains.size());
    for (const NamedShape& grain : templates.grains)
    {
        const Outline exact = outline(grain.shape);
        described.push_back(
            {grain.name, "template", outlinePoints(exact, drawnTolerance * boundingRadius(grain.shape)), describe(grain.shape)});
    }
    return described;
}

void writeDescriptors(const std::string& path, const std::vector<DescribedGrain>& grains, const std::string& unit)
{
    writeAside(
        path,
        [&](std::ostream& file)
        {
            file << "# unit " << unit << ", angles in degrees\n"
                 << "id,outline,equivalentDiameter,area,perimeter,elongation,elongationAngle,roundness,cornerRoundness,"
                    "circularity,sphericity,convexity,regularity,inscribedX,inscribedY,inscribedRadius,circumscribedX,"
                    "circumscribedY,circumscribedRadius\n"
                 << std::setprecision(9);
            for (const DescribedGrain& grain : grains)
            {
                file << grain.name << ',' << grain.source;
                writeRow(file, grain.shape);
                file << '\n';
            }
        });
}

void writeSpectra(const std::string& path, const std::vector<DescribedGrain>& grains)
{
    writeAside(
        path,
        [&](std::ostream& file)
        {
            constexpr std::size_t last = 64;
            file << "id";
            for (std::size_t n = 0; n <= last; ++n)
            {
                file << ",D" << n;
            }
            file << '\n' << std::setprecision(9);
            for (const DescribedGrain& grain : grains)
            {
                file << grain.name;
                for (std::size_t n = 0; n <= last; ++n)
                {
                    file << ',';
                    if (grain.shape.spectrum)
                    {
                        file << (*grain.shape.spectrum)[n];
                    }
                }
                file << '\n';
            }
        });
}

void writeOutlines(const std::string& path, const std::vector<DescribedGrain>& grains)
{
    writeAside(
        path,
        [&](std::ostream& file)
        {
            file << "id,x,y\n" << std::setprecision(9);
            for (const DescribedGrain& grain : grains)
            {
                for (const Vector2& point : grain.outline)
                {
                    file << grain.name << ',' << point.x() << ',' << point.y() << '\n';
                }
            }
        });
}

} // namespace chesil
