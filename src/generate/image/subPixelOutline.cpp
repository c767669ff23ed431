#include "generate/image/subPixelOutline.hpp"

#include "generate/image/convexHull.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace chesil
{

namespace
{

/// A pixel edge of the silhouette's outer boundary, walked with the grain on the left.
struct Crack
{
    int insideX;
    int insideY;
    int stepX; // from the pixel inside to the one outside
    int stepY;
};

/// The outer boundary, from the leftmost pixel of the lowest row. Turns left where two pixels share a
/// corner only, so that it goes around pixels joined by their edges.
std::vector<Crack> outerBoundary(const Silhouette& silhouette)
{
    int x = 0;
    while (!silhouette.dark(x, 0))
    {
        ++x;
    }
    // Right, up, left, down; the pixel to the left of a step from the corner (x, y).
    constexpr std::array<std::array<int, 2>, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    constexpr std::array<std::array<int, 2>, 4> leftPixel{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    const int startX = x;
    int y = 0;
    std::size_t direction = 0;
    std::vector<Crack> cracks;
    do
    {
        const std::size_t toTheRight = (direction + 3) % 4;
        cracks.push_back({x + leftPixel[direction][0], y + leftPixel[direction][1], steps[toTheRight][0],
                          steps[toTheRight][1]});
        x += steps[direction][0];
        y += steps[direction][1];
        const int aheadX = x + leftPixel[direction][0];
        const int aheadY = y + leftPixel[direction][1];
        if (!silhouette.dark(aheadX, aheadY))
        {
            direction = (direction + 1) % 4;
        }
        else if (silhouette.dark(aheadX + steps[toTheRight][0], aheadY + steps[toTheRight][1]))
        {
            direction = toTheRight;
        }
    } while (x != startX || y != 0 || direction != 0);
    return cracks;
}

/// 0 of none.
double median(std::vector<int>& values)
{
    if (values.empty())
    {
        return 0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The grey values around a silhouette, in its frame.
class GreyAround
{
public:
    GreyAround(const GreyImage& image, const Silhouette& silhouette)
        : image_(image), silhouette_(silhouette), left_(static_cast<int>(silhouette.corner().x())),
          bottom_(static_cast<int>(silhouette.corner().y()))
    {
    }

    bool has(int x, int y) const
    {
        return left_ + x >= 0 && left_ + x < image_.width() && bottom_ + y >= 0 &&
               bottom_ + y < image_.height();
    }

    int value(int x, int y) const { return image_.value(left_ + x, bottom_ + y); }

    /// Without the holes that were filled.
    double grainMedian(const GreyLevel& level) const
    {
        std::vector<int> values;
        for (int y = 0; y < silhouette_.height(); ++y)
        {
            for (int x = 0; x < silhouette_.width(); ++x)
            {
                if (silhouette_.dark(x, y) && level.depth(value(x, y)) > 0)
                {
                    values.push_back(value(x, y));
                }
            }
        }
        return median(values);
    }

    /// Two pixels away from the grain, where a mixed pixel no longer reaches.
    double groundMedian(const std::vector<Crack>& cracks) const
    {
        std::vector<int> values;
        for (const Crack& crack : cracks)
        {
            const int x = crack.insideX + 2 * crack.stepX;
            const int y = crack.insideY + 2 * crack.stepY;
            if (has(x, y))
            {
                values.push_back(value(x, y));
            }
        }
        return median(values);
    }

private:
    const GreyImage& image_;
    const Silhouette& silhouette_;
    int left_;
    int bottom_;
};

/// Grey values of what is all grain and all ground.
struct GreyEnds
{
    double grain;
    double ground;

    /// Share of a pixel that the grain covers.
    double covered(int grey) const { return std::clamp((grey - ground) / (grain - ground), 0.0, 1.0); }
};

bool hasMixedPixels(const GreyAround& around, const GreyEnds& ends, const std::vector<Crack>& cracks)
{
    constexpr double leastShare = 0.25;
    const auto isMixed = [&](int grey) { return std::abs(ends.covered(grey) - 0.5) < 0.25; };
    const auto mixed = std::count_if(
        cracks.begin(), cracks.end(),
        [&](const Crack& crack)
        {
            return isMixed(around.value(crack.insideX, crack.insideY)) ||
                   isMixed(around.value(crack.insideX + crack.stepX, crack.insideY + crack.stepY));
        });
    return static_cast<double>(mixed) >= leastShare * static_cast<double>(cracks.size());
}

/// How far from the inner pixel's centre the edge crosses the line of pixels through a crack [pixel], if it does so once: all
/// grain two pixels within, all ground two pixels beyond, and falling between. Then the sum of what is covered is exactly
/// the length of the grain's part, the mean over the pixels' breadth.
std::optional<double> edgeByCoverage(const GreyAround& around, const GreyEnds& ends, const Crack& crack)
{
    constexpr double all = 0.9;
    std::array<double, 4> covered{};
    for (int k = 0; k < 4; ++k)
    {
        const int x = crack.insideX + (k - 1) * crack.stepX;
        const int y = crack.insideY + (k - 1) * crack.stepY;
        if (!around.has(x, y))
        {
            return std::nullopt;
        }
        covered[static_cast<std::size_t>(k)] = ends.covered(around.value(x, y));
    }
    if (covered.front() < all || covered.back() > 1 - all || !std::is_sorted(covered.rbegin(), covered.rend()))
    {
        return std::nullopt;
    }
    return covered[0] + covered[1] + covered[2] + covered[3] - 1.5;
}

/// The same by linear interpolation between the centres.
double edgeByLevel(const GreyAround& around, const GreyLevel& level, const Crack& crack)
{
    const double inside = level.depth(around.value(crack.insideX, crack.insideY));
    const double outside = level.depth(around.value(crack.insideX + crack.stepX, crack.insideY + crack.stepY));
    return outside < 0 ? inside / (inside - outside) : 0.5;
}

bool hasAround(const Silhouette& silhouette, int x, int y, bool dark)
{
    for (int dy = -1; dy <= 1; ++dy)
    {
        for (int dx = -1; dx <= 1; ++dx)
        {
            if (silhouette.dark(x + dx, y + dy) == dark)
            {
                return true;
            }
        }
    }
    return false;
}

/// Area of the grain by what it covers of the pixels along its edge [pixel^2].
double coveredArea(const GreyAround& around, const GreyEnds& ends, const Silhouette& silhouette)
{
    double area = 0;
    for (int y = -1; y <= silhouette.height(); ++y)
    {
        for (int x = -1; x <= silhouette.width(); ++x)
        {
            const bool within = silhouette.dark(x, y) && !hasAround(silhouette, x, y, false);
            const bool along = !within && hasAround(silhouette, x, y, true);
            area += within ? 1 : along && around.has(x, y) ? ends.covered(around.value(x, y)) : 0;
        }
    }
    return area;
}

/// Each vertex along its normal, all by the same way, until the area is the wanted one. Not at all if that is farther than what chords
/// and means over a pixel's breadth cut off a grain of five pixels: then the area holds something else, a neighbour, say.
void moveOutward(std::vector<Vector2>& outline, double area)
{
    const std::size_t size = outline.size();
    std::vector<Vector2> normals;
    double perimeter = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
        normals.push_back(-perpendicular(unit(outline[(i + 1) % size] - outline[(i + size - 1) % size])));
        perimeter += (outline[(i + 1) % size] - outline[i]).norm();
    }
    constexpr double farthest = 0.06;
    const double way = (area - polygonArea(outline)) / perimeter;
    if (std::abs(way) > farthest)
    {
        return;
    }
    for (std::size_t i = 0; i < size; ++i)
    {
        outline[i] += way * normals[i];
    }
}

} // namespace

std::vector<Vector2> pixelOutline(const Silhouette& silhouette)
{
    std::vector<Vector2> outline;
    for (const Crack& crack : outerBoundary(silhouette))
    {
        outline.emplace_back(crack.insideX + (1 + crack.stepX) / 2.0, crack.insideY + (1 + crack.stepY) / 2.0);
    }
    return outline;
}

std::vector<Vector2> subPixelOutline(const GreyImage& image, const GreyLevel& level,
                                     const Silhouette& silhouette)
{
    const std::vector<Crack> cracks = outerBoundary(silhouette);
    const GreyAround around(image, silhouette);
    const GreyEnds ends{around.grainMedian(level), around.groundMedian(cracks)};
    if (!hasMixedPixels(around, ends, cracks))
    {
        return {};
    }
    std::vector<Vector2> outline;
    outline.reserve(cracks.size());
    for (const Crack& crack : cracks)
    {
        const std::optional<double> exact = edgeByCoverage(around, ends, crack);
        const double share = exact ? *exact : edgeByLevel(around, level, crack);
        outline.emplace_back(crack.insideX + 0.5 + share * crack.stepX, crack.insideY + 0.5 + share * crack.stepY);
    }
    // Chords, and means over a pixel's breadth, cut about a pixel off a round grain's area, whatever its size.
    moveOutward(outline, coveredArea(around, ends, silhouette));
    return outline;
}

} // namespace chesil
