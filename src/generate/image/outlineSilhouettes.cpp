#include "generate/image/outlineSilhouettes.hpp"

#include "core/base/setupError.hpp"
#include "generate/image/outlineFile.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

namespace chesil
{

namespace
{

using Box = Eigen::AlignedBox<double, 2>;

std::string endingOf(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    for (char& letter : ending)
    {
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    return ending;
}

Box boxAround(const std::vector<Vector2>& outline)
{
    Box box;
    for (const Vector2& vertex : outline)
    {
        box.extend(vertex);
    }
    return box;
}

/// The size of a pixel, in the outlines' unit.
double pixelSizeFor(const std::string& path, const OutlineFile& file)
{
    std::vector<double> sizes;
    for (const std::vector<Vector2>& outline : file.outlines)
    {
        sizes.push_back(boxAround(outline).sizes().maxCoeff());
    }
    std::vector<double> sorted = sizes;
    std::sort(sorted.begin(), sorted.end());
    const double median = sorted[sorted.size() / 2];
    const auto largest = std::max_element(sizes.begin(), sizes.end());
    if (*largest > mostTimesTheMedian * median)
    {
        throw SetupError(path, "outline " + std::to_string(largest - sizes.begin() + 1),
                         numberText(*largest / median) + " times the size of the median one",
                         "grains only, at most " + std::to_string(mostTimesTheMedian) + " times the median");
    }
    return median / outlinePixelsAcross;
}

/// A row of the silhouette is dark from each first to the next second place where it enters and leaves.
void fillRow(const std::vector<Vector2>& outline, int y, int width, std::vector<double>& crossings,
             std::uint8_t* row)
{
    const double height = y + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
        const Vector2& a = outline[i];
        const Vector2& b = outline[(i + 1) % outline.size()];
        if ((a.y() < height) != (b.y() < height))
        {
            crossings.push_back(a.x() + (height - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
    }
    std::sort(crossings.begin(), crossings.end());
    const auto firstPixel = [width](double x)
    { return std::clamp(static_cast<int>(std::ceil(x - 0.5)), 0, width); };
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    {
        std::fill(row + firstPixel(crossings[i]), row + firstPixel(crossings[i + 1]), std::uint8_t{1});
    }
}

Silhouette drawn(std::vector<Vector2> outline, double pixelSize)
{
    const Box box = boxAround(outline);
    const Vector2 corner = (box.min() / pixelSize).array().floor();
    for (Vector2& vertex : outline)
    {
        vertex = (vertex - corner * pixelSize) / pixelSize;
    }
    const Box local = boxAround(outline);
    const int width = std::max(1, static_cast<int>(std::ceil(local.max().x())));
    const int height = std::max(1, static_cast<int>(std::ceil(local.max().y())));
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    std::vector<double> crossings;
    for (int y = 0; y < height; ++y)
    {
        fillRow(outline, y, width, crossings,
                pixels.data() + static_cast<std::ptrdiff_t>(y) * static_cast<std::ptrdiff_t>(width));
    }
    Silhouette silhouette(width, height, pixels, corner);
    silhouette.setOutline(std::move(outline));
    return silhouette;
}

/// The file's names, grainName for outlines without one; none if no outline has one.
std::vector<std::string> namesOf(const std::string& path, const OutlineFile& file)
{
    if (std::all_of(file.names.begin(), file.names.end(), [](const auto& name) { return name.empty(); }))
    {
        return {};
    }
    std::vector<std::string> names;
    std::map<std::string, std::string> places;
    for (std::size_t i = 0; i < file.names.size(); ++i)
    {
        const std::string name = file.names[i].empty() ? grainName(i) : file.names[i];
        const auto isForbidden = [](unsigned char letter)
        { return letter <= ' ' || letter == 127 || letter == '#' || letter == ',' || letter == '"'; };
        if (std::any_of(name.begin(), name.end(), isForbidden))
        {
            throw SetupError(path, file.places[i], "the name '" + name + "'",
                             "a name without blanks and without # , \"");
        }
        const auto [other, isNew] = places.emplace(name, file.places[i]);
        if (!isNew)
        {
            throw SetupError(path, file.places[i],
                             "the name '" + name + "', which " + other->second + " has, too",
                             "a name of its own for each outline");
        }
        names.push_back(name);
    }
    return names;
}

} // namespace

bool isOutlinePath(const std::string& path)
{
    const std::string ending = endingOf(path);
    return ending == ".csv" || ending == ".geojson" || ending == ".json";
}

ImageGrains readOutlineGrains(const std::string& path)
{
    OutlineFile file = endingOf(path) == ".csv" ? readCsvOutlines(path) : readGeoJsonOutlines(path);
    ImageGrains result;
    result.kind = ImageKind::outlines;
    result.names = namesOf(path, file);
    result.holesFilled = file.holes;
    result.pixelSize = pixelSizeFor(path, file);
    for (std::vector<Vector2>& outline : file.outlines)
    {
        Silhouette silhouette = drawn(std::move(outline), result.pixelSize);
        if (silhouette.count() == 0)
        {
            throw SetupError(path, "outline " + std::to_string(result.grains.size() + 1),
                             "less than a pixel, if the median one has " +
                                 std::to_string(outlinePixelsAcross) + " across",
                             "outlines of grains of like sizes");
        }
        result.grains.push_back(std::move(silhouette));
    }
    return result;
}

} // namespace chesil
