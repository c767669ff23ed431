#include "generate/image/greyGrains.hpp"

#include "core/base/setupError.hpp"
#include "generate/image/greyImage.hpp"
#include "generate/image/pixelGrains.hpp"

#include <algorithm>

namespace chesil
{

namespace
{

/// Where a label's pixels lie.
struct LabelBox
{
    int left = 0;
    int right = -1;
    int bottom = 0;
    int top = -1;

    bool isEmpty() const { return right < left; }
};

std::vector<LabelBox> boxesOf(const GreyImage& labels)
{
    std::vector<LabelBox> boxes(static_cast<std::size_t>(labels.largest()) + 1);
    for (int y = 0; y < labels.height(); ++y)
    {
        for (int x = 0; x < labels.width(); ++x)
        {
            LabelBox& box = boxes[static_cast<std::size_t>(labels.value(x, y))];
            if (box.isEmpty())
            {
                box = {x, x, y, y};
            }
            box.left = std::min(box.left, x);
            box.right = std::max(box.right, x);
            box.top = y;
        }
    }
    return boxes;
}

Owned<Pix> pixelsOf(const GreyImage& labels, int label, const LabelBox& box)
{
    Owned<Pix> binary(pixCreate(box.right - box.left + 1, box.top - box.bottom + 1, 1));
    for (int y = box.bottom; y <= box.top; ++y)
    {
        for (int x = box.left; x <= box.right; ++x)
        {
            if (labels.value(x, y) == label)
            {
                pixSetPixel(binary.get(), x - box.left, box.top - y, 1);
            }
        }
    }
    return binary;
}

/// Sets of pixels sorted out so far.
std::size_t piecesOf(const ImageGrains& result)
{
    return result.grains.size() + static_cast<std::size_t>(result.specksDropped + result.borderDropped);
}

} // namespace

ImageGrains readLabelGrains(const std::string& path, const ImageSettings& settings)
{
    const GreyImage labels = readLabelImage(path);
    const int ground = settings.ground.value_or(0);
    if (ground < 0 || ground > labels.largest())
    {
        throw SetupError(path, "ground", std::to_string(ground),
                         "a value of 0 to " + std::to_string(labels.largest()));
    }
    const std::string expected =
        "a value for each grain and " + std::to_string(ground) + " for the ground (or -ground)";
    ImageGrains result;
    result.kind = ImageKind::labels;
    result.width = labels.width();
    result.height = labels.height();
    result.white = labels.largest();

    const std::vector<LabelBox> boxes = boxesOf(labels);
    for (int label = 0; label <= labels.largest(); ++label)
    {
        const LabelBox& box = boxes[static_cast<std::size_t>(label)];
        if (label == ground || box.isEmpty())
        {
            continue;
        }
        ++result.labels;
        const std::size_t before = piecesOf(result);
        const Owned<Pix> binary = pixelsOf(labels, label, box);
        sortOut({binary.get(), box.left, labels.height() - 1 - box.top}, settings.minPixels, result,
                [&](Silhouette&& silhouette) { result.grains.push_back(std::move(silhouette)); });
        result.labelsInPieces += piecesOf(result) > before + 1 ? 1 : 0;
    }
    if (result.labels == 0)
    {
        throw SetupError(path, "image", "no label (the value " + std::to_string(ground) + " everywhere)",
                         expected);
    }
    if (result.grains.empty())
    {
        throw SetupError(path, "image",
                         "no whole grain (" + std::to_string(result.labels) + " labels; " +
                             droppedText(result, settings.minPixels) + ")",
                         expected);
    }
    return result;
}

} // namespace chesil
