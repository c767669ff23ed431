#include "generate/image/greyGrains.hpp"

#include "core/base/setupError.hpp"
#include "generate/image/pixelGrains.hpp"
#include "generate/image/subPixelOutline.hpp"
#include "generate/image/touchingGrains.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

namespace
{

std::string expectedGrains(const ImageSettings& settings)
{
    return settings.lightGrains ? "light grains on a dark ground" : "dark grains on a light ground";
}

int countOf(const Numa& histogram, int value) { return static_cast<int>(histogram.array[value]); }

/// Otsu's threshold: the darker class's last grey value, at least `first` and less than `last`.
int otsuSplit(const Numa& histogram, int first, int last)
{
    // Leptonica's function overflows on the 65536 values of 16 bits.
    constexpr int mostBins = 1024;
    const int valuesPerBin = (last - first) / mostBins + 1;
    const Owned<Numa> bins(numaMakeConstant(0, (last - first) / valuesPerBin + 1));
    for (int value = first; value <= last; ++value)
    {
        numaShiftValue(bins.get(), (value - first) / valuesPerBin,
                       static_cast<l_float32>(countOf(histogram, value)));
    }
    l_int32 split = 0;
    numaSplitDistribution(bins.get(), 0, &split, nullptr, nullptr, nullptr, nullptr, nullptr);
    return std::min(first + (split + 1) * valuesPerBin - 1, last - 1);
}

/// Otsu's threshold, in the middle between the two classes' next values, where every one between them does.
int otsuThreshold(const std::string& path, const GreyImage& grey, const ImageSettings& settings)
{
    const Owned<Numa> histogram(pixGetGrayHistogram(grey.pixels(), 1));
    l_int32 first = 0;
    l_int32 last = 0;
    if (!histogram || numaGetNonzeroRange(histogram.get(), 0, &first, &last) != 0 || first == last)
    {
        throw SetupError(path, "image", "one grey value (" + std::to_string(first) + ") everywhere",
                         expectedGrains(settings));
    }
    int dark = otsuSplit(*histogram, first, last);
    int light = dark + 1;
    while (countOf(*histogram, dark) == 0)
    {
        --dark;
    }
    while (countOf(*histogram, light) == 0)
    {
        ++light;
    }
    return (dark + light) / 2;
}

int thresholdOf(const std::string& path, const GreyImage& grey, const ImageSettings& settings)
{
    if (!settings.threshold)
    {
        return otsuThreshold(path, grey, settings);
    }
    if (*settings.threshold < 0 || *settings.threshold >= grey.largest())
    {
        throw SetupError(path, "threshold", std::to_string(*settings.threshold),
                         "a grey value of 0 to " + std::to_string(grey.largest() - 1));
    }
    return *settings.threshold;
}

Owned<Pix> grainPixels(const GreyImage& grey, const GreyLevel& level)
{
    Owned<Pix> binary(pixCreate(grey.width(), grey.height(), 1));
    const int wordsPerRow = pixGetWpl(binary.get());
    for (int y = 0; y < grey.height(); ++y)
    {
        l_uint32* row =
            pixGetData(binary.get()) + static_cast<std::ptrdiff_t>(grey.height() - 1 - y) * wordsPerRow;
        for (int x = 0; x < grey.width(); ++x)
        {
            if (level.depth(grey.value(x, y)) > 0)
            {
                SET_DATA_BIT(row, x);
            }
        }
    }
    return binary;
}

void keepGrain(Silhouette&& silhouette, const GreyImage& grey, const GreyLevel& level,
               const ImageSettings& settings, ImageGrains& result)
{
    TouchCriterion criterion;
    criterion.minPixels = settings.minPixels;
    std::vector<Silhouette> parts = partsAtNecks(silhouette, criterion);
    if (parts.size() > 1)
    {
        result.touching.push_back({result.grains.size(), static_cast<int>(parts.size())});
    }
    if (!settings.split)
    {
        parts.assign(1, std::move(silhouette));
    }
    for (Silhouette& part : parts)
    {
        part.setOutline(subPixelOutline(grey, level, part));
        result.grains.push_back(std::move(part));
    }
}

SetupError noWholeGrain(const std::string& path, const ImageSettings& settings, const ImageGrains& result)
{
    std::string found = "no whole grain (grey values " +
                        (settings.lightGrains ? "from " + std::to_string(result.threshold + 1)
                                              : "up to " + std::to_string(result.threshold)) +
                        " taken as grain; " + droppedText(result, settings.minPixels) + ")";
    std::string expected = expectedGrains(settings);
    if (result.borderShare > mostlyGrain)
    {
        found += ", and " + std::to_string(std::lround(100 * result.borderShare)) +
                 " % of the border taken as one grain";
        expected += settings.lightGrains ? "; for dark grains on a light one leave out -light"
                                         : "; for light grains on a dark one give -light";
    }
    return SetupError(path, "image", found, expected);
}

} // namespace

ImageGrains readGreyGrains(const std::string& path, const ImageSettings& settings)
{
    const GreyImage grey = readGreyImage(path, settings.lightGrains);
    ImageGrains result;
    result.width = grey.width();
    result.height = grey.height();
    result.white = grey.largest();
    result.threshold = thresholdOf(path, grey, settings);
    const GreyLevel level{result.threshold + 0.5, settings.lightGrains};

    const Owned<Pix> binary = grainPixels(grey, level);
    sortOut({binary.get(), 0, 0}, settings.minPixels, result,
            [&](Silhouette&& silhouette)
            { keepGrain(std::move(silhouette), grey, level, settings, result); });
    if (result.grains.empty())
    {
        throw noWholeGrain(path, settings, result);
    }
    return result;
}

} // namespace chesil
