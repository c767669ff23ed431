#include "generate/image/pixelGrains.hpp"

#include <algorithm>

namespace chesil
{

namespace
{

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
    return Silhouette(width, height, pixels, Vector2(left, bottom));
}

/// Returns the number of holes: sets of pixels, joined by edges or corners, that the component encloses.
int fillHoles(Pix* component)
{
    const Owned<Pix> framed(pixAddBorder(component, 1, 0));
    const Owned<Pix> holesFramed(pixHolesByFilling(framed.get(), 8));
    const Owned<Pix> holes(pixRemoveBorder(holesFramed.get(), 1));
    l_int32 count = 0;
    pixCountConnComp(holes.get(), 8, &count);
    if (count > 0)
    {
        pixOr(component, component, holes.get());
    }
    return count;
}

/// The share of the image's border that a component has.
double borderShare(Pix* component, bool left, bool right, bool top, bool bottom, const ImageGrains& image)
{
    const int width = pixGetWidth(component);
    const int height = pixGetHeight(component);
    int count = 0;
    const auto add = [&](int x, int y)
    {
        l_uint32 dark = 0;
        pixGetPixel(component, x, y, &dark);
        count += static_cast<int>(dark);
    };
    for (int x = 0; x < width; ++x)
    {
        if (top)
        {
            add(x, 0);
        }
        if (bottom)
        {
            add(x, height - 1);
        }
    }
    for (int y = 0; y < height; ++y)
    {
        if (left)
        {
            add(0, y);
        }
        if (right)
        {
            add(width - 1, y);
        }
    }
    return count / (2.0 * (image.width + image.height));
}

} // namespace

void sortOut(const BinaryPart& part, int minPixels, ImageGrains& result,
             const std::function<void(Silhouette&&)>& keep)
{
    Pixa* componentsGiven = nullptr;
    const Owned<Boxa> boxes(pixConnCompPixa(part.pixels, &componentsGiven, 4));
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
        left += part.left;
        top += part.top;
        const bool atRight = left + width == result.width;
        const bool atBottom = top + height == result.height;
        if (left == 0 || top == 0 || atRight || atBottom)
        {
            ++result.borderDropped;
            result.borderShare = std::max(result.borderShare, borderShare(component.get(), left == 0, atRight,
                                                                          top == 0, atBottom, result));
            continue;
        }
        result.holesFilled += fillHoles(component.get());
        keep(toSilhouette(component.get(), left, result.height - top - height));
    }
}

std::string droppedText(const ImageGrains& result, int minPixels)
{
    return std::to_string(result.specksDropped) + " specks of fewer than " + std::to_string(minPixels) +
           " pixels, " + std::to_string(result.borderDropped) + " grains touching the border";
}

} // namespace chesil
