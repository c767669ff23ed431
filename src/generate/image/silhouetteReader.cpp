#include "generate/image/silhouetteReader.hpp"

#include "core/base/setupError.hpp"

#include <leptonica/allheaders.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

namespace chesil
{

namespace
{

struct Destroy
{
    void operator()(Pix* image) const { pixDestroy(&image); }
    void operator()(Numa* numbers) const { numaDestroy(&numbers); }
    void operator()(Boxa* boxes) const { boxaDestroy(&boxes); }
    void operator()(Pixa* images) const { pixaDestroy(&images); }
};

template <class T>
using Owned = std::unique_ptr<T, Destroy>;

/// Leptonica reports on standard error; for as long as this lives it is silent, since we throw.
class QuietLeptonica
{
public:
    QuietLeptonica() : before_(setMsgSeverity(L_SEVERITY_NONE)) {}
    ~QuietLeptonica() { setMsgSeverity(before_); }
    QuietLeptonica(const QuietLeptonica&) = delete;
    QuietLeptonica& operator=(const QuietLeptonica&) = delete;

private:
    int before_;
};

Owned<Pix> readGrey(const std::string& path)
{
    errno = 0;
    if (!std::ifstream(path, std::ios::binary).good())
    {
        throw SetupError(path, "image", std::strerror(errno), "an image file that can be read");
    }
    const Owned<Pix> asStored(pixRead(path.c_str()));
    const Owned<Pix> opaque(asStored ? pixRemoveAlpha(asStored.get()) : nullptr);
    Owned<Pix> grey(opaque ? pixConvertTo8(opaque.get(), 0) : nullptr);
    if (!grey)
    {
        throw SetupError(path, "image", "no image, or one that is cut short or damaged",
                         "a whole PNG, JPEG or TIFF image");
    }
    return grey;
}

/// Otsu's threshold: the last grey value of the darker class, which never holds the lightest value.
int otsuThreshold(const std::string& path, Pix* grey)
{
    const Owned<Numa> histogram(pixGetGrayHistogram(grey, 1));
    l_int32 first = 0;
    l_int32 last = 0;
    if (!histogram || numaGetNonzeroRange(histogram.get(), 0, &first, &last) != 0 || first == last)
    {
        throw SetupError(path, "image", "one grey value (" + std::to_string(first) + ") everywhere",
                         "dark grains on a light ground");
    }
    l_int32 split = 0;
    numaSplitDistribution(histogram.get(), 0, &split, nullptr, nullptr, nullptr, nullptr, nullptr);
    return std::min(split, last - 1);
}

Silhouette toSilhouette(Pix* component, int left, int bottom)
{
    const int width = pixGetWidth(component);
    const int height = pixGetHeight(component);
    std::vector<std::uint8_t> pixels;
    pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            l_uint32 dark = 0;
            pixGetPixel(component, x, height - 1 - y, &dark);
            pixels.push_back(static_cast<std::uint8_t>(dark));
        }
    }
    return Silhouette(width, height, std::move(pixels), Vector2(left, bottom));
}

void sortOut(Pix* binary, int minPixels, ImageGrains& result)
{
    Pixa* componentsGiven = nullptr;
    const Owned<Boxa> boxes(pixConnCompPixa(binary, &componentsGiven, 4));
    const Owned<Pixa> components(componentsGiven);
    for (int i = 0; i < pixaGetCount(components.get()); ++i)
    {
        const Owned<Pix> component(pixaGetPix(components.get(), i, L_CLONE));
        l_int32 pixels = 0;
        pixCountPixels(component.get(), &pixels, nullptr);
        if (pixels < minPixels)
        {
            ++result.specksDropped;
            continue;
        }
        l_int32 left = 0;
        l_int32 top = 0;
        l_int32 width = 0;
        l_int32 height = 0;
        boxaGetBoxGeometry(boxes.get(), i, &left, &top, &width, &height);
        if (left == 0 || top == 0 || left + width == result.width || top + height == result.height)
        {
            ++result.borderDropped;
            continue;
        }
        result.grains.push_back(toSilhouette(component.get(), left, result.height - top - height));
    }
}

void check(const std::string& path, const ImageSettings& settings)
{
    if (settings.minPixels < 1)
    {
        throw SetupError(path, "minPixels", std::to_string(settings.minPixels), "at least 1");
    }
    if (settings.threshold && (*settings.threshold < 0 || *settings.threshold > 254))
    {
        throw SetupError(path, "threshold", std::to_string(*settings.threshold), "a grey value of 0 to 254");
    }
}

} // namespace

ImageGrains readGrains(const std::string& path, const ImageSettings& settings)
{
    check(path, settings);
    const QuietLeptonica quiet;
    const Owned<Pix> grey = readGrey(path);

    ImageGrains result;
    result.width = pixGetWidth(grey.get());
    result.height = pixGetHeight(grey.get());
    result.threshold = settings.threshold ? *settings.threshold : otsuThreshold(path, grey.get());
    // Leptonica takes what is below its threshold as dark.
    const Owned<Pix> binary(pixThresholdToBinary(grey.get(), result.threshold + 1));
    if (!binary)
    {
        throw SetupError(path, "image", "an image that cannot be split at a grey value",
                         "dark grains on a light ground");
    }
    sortOut(binary.get(), settings.minPixels, result);
    if (result.grains.empty())
    {
        throw SetupError(path, "image",
                         "no whole grain (grey values up to " + std::to_string(result.threshold) +
                             " taken as grain; " + std::to_string(result.specksDropped) +
                             " specks of fewer than " + std::to_string(settings.minPixels) + " pixels, " +
                             std::to_string(result.borderDropped) + " grains touching the border)",
                         "dark grains on a light ground");
    }
    return result;
}

} // namespace chesil
