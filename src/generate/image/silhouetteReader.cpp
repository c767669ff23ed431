#include "generate/image/silhouetteReader.hpp"

#include "core/base/setupError.hpp"
#include "generate/image/greyGrains.hpp"
#include "generate/image/leptonicaHandles.hpp"
#include "generate/image/outlineSilhouettes.hpp"

namespace chesil
{

namespace
{

void refuseIf(bool given, const std::string& path, const std::string& setting, const std::string& found,
              const std::string& expected)
{
    if (given)
    {
        throw SetupError(path, setting, found, expected);
    }
}

void check(const std::string& path, const ImageSettings& settings)
{
    if (settings.minPixels < 1)
    {
        throw SetupError(path, "minPixels", std::to_string(settings.minPixels), "at least 1");
    }
    const bool outlines = isOutlinePath(path);
    const std::string kind = outlines ? "it with outlines" : "it with labels";
    const std::string needs = "none of light, threshold, split there: they belong to grey images";
    const bool notGrey = outlines || settings.labels;
    refuseIf(outlines && settings.labels, path, "labels", kind, "a label image: PNG or TIFF");
    refuseIf(notGrey && settings.lightGrains, path, "light", kind, needs);
    refuseIf(notGrey && settings.threshold, path, "threshold", kind, needs);
    refuseIf(notGrey && settings.split, path, "split", kind, needs);
    refuseIf(settings.ground && !settings.labels, path, "ground", "it without labels",
             "it beside labels only");
}

} // namespace

ImageGrains readGrains(const std::string& path, const ImageSettings& settings)
{
    check(path, settings);
    if (isOutlinePath(path))
    {
        return readOutlineGrains(path);
    }
    const QuietLeptonica quiet;
    return settings.labels ? readLabelGrains(path, settings) : readGreyGrains(path, settings);
}

std::string ImageGrains::name(std::size_t index) const
{
    return names.empty() ? grainName(index) : names[index];
}

std::string grainName(std::size_t index) { return "grain" + std::to_string(index + 1); }

} // namespace chesil
