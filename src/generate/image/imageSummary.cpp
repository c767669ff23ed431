#include "generate/image/imageSummary.hpp"

#include "core/base/setupError.hpp"
#include "generate/image/greyGrains.hpp"
#include "generate/image/touchingGrains.hpp"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace chesil
{

namespace
{

/// "3: grain1 (2 parts), grain7 (4 parts), ...": of long lists the first ones.
std::string counted(const std::vector<std::string>& names)
{
    constexpr std::size_t mostShown = 20;
    const std::vector<std::string> shown(
        names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), mostShown)));
    return std::to_string(names.size()) + ": " + listOfNames(shown) +
           (names.size() > mostShown ? ", ..." : "");
}

std::string twoDigits(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

std::vector<std::string> touchingNames(const ImageGrains& image)
{
    std::vector<std::string> names;
    for (const TouchingGrains& touching : image.touching)
    {
        names.push_back(image.name(touching.grain) + " (" + std::to_string(touching.parts) + " parts)");
    }
    return names;
}

std::vector<std::string> hollowNames(const ImageGrains& image)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < image.grains.size(); ++i)
    {
        const double share = convexity(image.grains[i]);
        if (share < farFromConvex)
        {
            names.push_back(image.name(i) + " (convexity " + twoDigits(share) + ")");
        }
    }
    return names;
}

} // namespace

std::string imageTitle(const std::string& path, const ImageGrains& image, const ImageSettings& settings)
{
    if (image.kind == ImageKind::outlines)
    {
        return "Outlines " + path + ": " + std::to_string(image.grains.size());
    }
    std::ostringstream text;
    text << "Image " << path << ": " << image.width << " x " << image.height << " pixels, ";
    if (image.kind == ImageKind::labels)
    {
        text << "labels on ground " << settings.ground.value_or(0);
    }
    else if (settings.lightGrains)
    {
        text << "grey values from " << image.threshold + 1 << " taken as grain";
    }
    else
    {
        text << "grey values up to " << image.threshold << " taken as grain";
    }
    if (image.white != 255)
    {
        text << " (white is " << image.white << ")";
    }
    return text.str();
}

std::string imageFindings(const ImageGrains& image, const ImageSettings& settings)
{
    std::ostringstream text;
    if (image.kind != ImageKind::outlines)
    {
        text << "Specks dropped            " << image.specksDropped << " (fewer than " << settings.minPixels
             << " pixels)\n"
             << "Border-touching dropped   " << image.borderDropped << '\n';
    }
    text << "Holes filled              " << image.holesFilled << '\n';
    if (image.labelsInPieces > 0)
    {
        text << "Labels in pieces          " << image.labelsInPieces << " of " << image.labels
             << "; each piece is taken by itself\n";
    }
    const std::vector<std::string> touching = touchingNames(image);
    if (!touching.empty())
    {
        text << (settings.split ? "Cut apart                 " : "Seem to touch             ")
             << counted(touching) << (settings.split ? "" : "; -split cuts them apart") << '\n';
    }
    const std::vector<std::string> hollow = hollowNames(image);
    if (!hollow.empty())
    {
        text << "Warning: far from convex  " << counted(hollow) << "; a template fills their hollows\n";
    }
    if (image.borderShare > mostlyGrain)
    {
        text << "Warning: " << std::lround(100 * image.borderShare)
             << " % of the image's border is one grain; "
             << (settings.lightGrains ? "dark grains on a light ground are read without -light\n"
                                      : "light grains on a dark ground need -light\n");
    }
    return text.str();
}

} // namespace chesil
