#include "generate/image/touchingGrains.hpp"

#include "generate/image/convexHull.hpp"
#include "generate/image/leptonicaHandles.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace chesil
{

namespace
{

/// Half width at each pixel of the silhouette with a margin of one pixel, bottom row first; 0 on the ground.
class HalfWidths
{
public:
    explicit HalfWidths(const Silhouette& silhouette)
        : width_(silhouette.width() + 2), height_(silhouette.height() + 2)
    {
        const Owned<Pix> mask(pixCreate(width_, height_, 1));
        for (int y = 0; y < silhouette.height(); ++y)
        {
            for (int x = 0; x < silhouette.width(); ++x)
            {
                pixSetPixel(mask.get(), x + 1, y + 1, silhouette.dark(x, y) ? 1 : 0);
            }
        }
        const Owned<Pix> cityBlock(pixDistanceFunction(mask.get(), 4, 16, L_BOUNDARY_BG));
        const Owned<Pix> chessboard(pixDistanceFunction(mask.get(), 8, 16, L_BOUNDARY_BG));
        values_.reserve(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        for (int y = 0; y < height_; ++y)
        {
            for (int x = 0; x < width_; ++x)
            {
                l_uint32 first = 0;
                l_uint32 second = 0;
                pixGetPixel(cityBlock.get(), x, y, &first);
                pixGetPixel(chessboard.get(), x, y, &second);
                // A pixel of the edge, with its centre half a pixel inside, has distance 1.
                values_.push_back(first == 0 ? 0 : (first + second) / 2.0 - 0.5);
            }
        }
    }

    int rowLength() const { return width_; }
    int size() const { return width_ * height_; }
    double operator[](int pixel) const { return values_[static_cast<std::size_t>(pixel)]; }

    std::array<int, 4> neighbours(int pixel) const
    {
        return {pixel - 1, pixel + 1, pixel - width_, pixel + width_};
    }

    /// The pixels of the silhouette, the widest places first.
    std::vector<int> fromTheWidest() const
    {
        std::vector<int> pixels;
        for (int pixel = 0; pixel < size(); ++pixel)
        {
            if ((*this)[pixel] > 0)
            {
                pixels.push_back(pixel);
            }
        }
        std::stable_sort(pixels.begin(), pixels.end(),
                         [this](int a, int b) { return (*this)[a] > (*this)[b]; });
        return pixels;
    }

private:
    int width_;
    int height_;
    std::vector<double> values_;
};

/// Which part each pixel belongs to: a forest, the root of a tree is the widest place of its part.
class Parts
{
public:
    Parts(const HalfWidths& halfWidths, const TouchCriterion& criterion)
        : halfWidths_(halfWidths), above_(static_cast<std::size_t>(halfWidths.size()), -1)
    {
        const std::vector<int> order = halfWidths.fromTheWidest();
        flood(order, criterion);
        joinSmallOnes(order, criterion.minPixels);
    }

    int root(int pixel)
    {
        while (above(pixel) != pixel)
        {
            above(pixel) = above(above(pixel));
            pixel = above(pixel);
        }
        return pixel;
    }

private:
    int& above(int pixel) { return above_[static_cast<std::size_t>(pixel)]; }

    bool isFlooded(int pixel) { return above(pixel) >= 0; }

    void join(int a, int b)
    {
        above(halfWidths_[a] < halfWidths_[b] ? a : b) = halfWidths_[a] < halfWidths_[b] ? b : a;
    }

    void flood(const std::vector<int>& order, const TouchCriterion& criterion)
    {
        const double bump = criterion.bumpWidth * halfWidths_[order.front()];
        for (const int pixel : order)
        {
            int widest = -1;
            for (const int neighbour : halfWidths_.neighbours(pixel))
            {
                if (isFlooded(neighbour) && (widest < 0 || halfWidths_[neighbour] > halfWidths_[widest]))
                {
                    widest = neighbour;
                }
            }
            above(pixel) = widest < 0 ? pixel : root(widest);
            for (const int neighbour : halfWidths_.neighbours(pixel))
            {
                if (!isFlooded(neighbour) || root(neighbour) == root(pixel))
                {
                    continue;
                }
                const double thinner = std::min(halfWidths_[root(neighbour)], halfWidths_[root(pixel)]);
                if (thinner < bump || halfWidths_[pixel] >= criterion.neckWidth * thinner)
                {
                    join(root(neighbour), root(pixel));
                }
            }
        }
    }

    void joinSmallOnes(const std::vector<int>& order, int minPixels)
    {
        std::map<int, int> counts;
        for (const int pixel : order)
        {
            ++counts[root(pixel)];
        }
        for (const int pixel : order)
        {
            for (const int neighbour : halfWidths_.neighbours(pixel))
            {
                const int a = root(pixel);
                const int b = isFlooded(neighbour) ? root(neighbour) : a;
                if (a != b && std::min(counts[a], counts[b]) < minPixels)
                {
                    const int sum = counts[a] + counts[b];
                    join(a, b);
                    counts[root(a)] = sum;
                }
            }
        }
    }

    const HalfWidths& halfWidths_;
    std::vector<int> above_;
};

/// In the box around them. `pixels`: numbers in a box of `rowLength` whose margin is one pixel.
Silhouette cutOut(const std::vector<int>& pixels, int rowLength, const Vector2& corner)
{
    int left = rowLength;
    int right = 0;
    for (const int pixel : pixels)
    {
        left = std::min(left, pixel % rowLength);
        right = std::max(right, pixel % rowLength);
    }
    const int bottom = pixels.front() / rowLength;
    const int top = pixels.back() / rowLength;
    const int width = right - left + 1;
    const int height = top - bottom + 1;
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    for (const int pixel : pixels)
    {
        mask[static_cast<std::size_t>((pixel / rowLength - bottom) * width + pixel % rowLength - left)] = 1;
    }
    return Silhouette(width, height, mask, corner + Vector2(left - 1, bottom - 1));
}

} // namespace

double convexity(const Silhouette& silhouette)
{
    return std::min(1.0, silhouette.count() / polygonArea(convexOutline(silhouette)));
}

std::vector<Silhouette> partsAtNecks(const Silhouette& silhouette, const TouchCriterion& criterion)
{
    if (convexity(silhouette) >= criterion.convexityOfOne)
    {
        return {silhouette};
    }
    const HalfWidths halfWidths(silhouette);
    Parts parts(halfWidths, criterion);
    std::map<int, std::vector<int>> pixelsOf;
    for (int pixel = 0; pixel < halfWidths.size(); ++pixel)
    {
        if (halfWidths[pixel] > 0)
        {
            pixelsOf[parts.root(pixel)].push_back(pixel);
        }
    }
    std::vector<std::vector<int>> fromTheTop;
    for (auto& [root, pixels] : pixelsOf)
    {
        fromTheTop.push_back(std::move(pixels));
    }
    std::sort(fromTheTop.begin(), fromTheTop.end(),
              [](const auto& a, const auto& b) { return a.back() > b.back(); });
    std::vector<Silhouette> found;
    for (const std::vector<int>& pixels : fromTheTop)
    {
        found.push_back(cutOut(pixels, halfWidths.rowLength(), silhouette.corner()));
    }
    return found;
}

} // namespace chesil
