#include "generate/descriptors/shapeDescriptors.hpp"
#include "generate/image/silhouetteReader.hpp"
#include "unit/generate/chartShapes.hpp"
#include "unit/generate/greyPicture.hpp"
#include "unit/randomGrain.hpp"
#include "unit/record.hpp"
#include "unit/temporaryFolder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

// What descriptors say of one shape, however it lies in the image.

using namespace chesil;

namespace
{

/// About 2 wide, around the origin.
using Inside = std::function<bool(const Vector2&)>;

struct DrawnShape
{
    std::string name;
    Inside inside;
};

Inside chart(double roundness)
{
    const test::RoundedPolygon shape = test::chartShape(0.7, roundness, 2);
    Vector2 middle = Vector2::Zero();
    for (const Vector2& vertex : shape.core)
    {
        middle += vertex / static_cast<double>(shape.core.size());
    }
    return [shape, middle](const Vector2& point) { return shape(point + middle); };
}

bool wavy(const Vector2& point)
{
    const double angle = std::atan2(point.y(), point.x());
    return point.norm() <= 0.8 + 0.1 * std::cos(2 * angle + 1) + 0.06 * std::cos(3 * angle) + 0.02 * std::cos(9 * angle);
}

std::vector<DrawnShape> shapes()
{
    return {
        {"ellipse", [](const Vector2& point) { return std::hypot(point.x(), point.y() / 0.6) <= 1; }},
        {"chart 0.1", chart(0.1)},
        {"chart 0.3", chart(0.3)},
        {"chart 0.7", chart(0.7)},
        {"wavy", wavy},
        {"square", [](const Vector2& point) { return std::max(std::abs(point.x()), std::abs(point.y())) <= 0.7; }},
    };
}

class PixelDescriptors : public test::TemporaryFolder
{
protected:
    /// 400 to 480 pixels across, turned and shifted at random; lengths over that.
    std::vector<double> seen(const Inside& inside, test::RandomSource& random)
    {
        const double across = random.uniform(400, 480);
        const int width = static_cast<int>(1.5 * across);
        const Vector2 middle = Vector2::Constant(0.75 * across) + Vector2(random.uniform(-3, 3), random.uniform(-3, 3));
        const Rotation<2> turn(random.uniform(0, 2 * M_PI));
        test::GreyPicture picture(width, width, 220);
        picture.shape([&](const Vector2& point) { return inside(turn.applyInverse(point - middle) / (across / 2)); }, 30);
        const std::string path = folder_ + "/picture.pgm";
        picture.write(path);
        const Silhouette grain = readGrains(path).grains.at(0);
        EXPECT_EQ(edgeAccuracy(grain), EdgeAccuracy::subPixel);
        const ShapeDescriptors found = describePixels(outlineToDescribe(grain), edgeAccuracy(grain));

        std::vector<double> numbers{
            std::log(found.area / (across * across)), std::log(found.perimeter / across), std::log(found.equivalentDiameter / across),
            std::log(found.inscribed.radius / across), std::log(found.circumscribed.radius / across), found.elongation, found.circularity,
            found.sphericity, found.convexity, found.roundness, found.cornerRoundness,
            // Above 3, the paper says, all outlines are as good as convex.
            std::log(std::min(found.regularity, 3.0))};
        numbers.insert(numbers.end(), found.spectrum->begin(), found.spectrum->end());
        return numbers;
    }
};

} // namespace

TEST_F(PixelDescriptors, hardlyKnowHowAGrainLies)
{
    const std::vector<std::string> names{"area", "perimeter", "equivalent diameter", "inscribed", "circumscribed", "elongation",
                                         "circularity", "sphericity", "convexity", "roundness", "corner roundness", "regularity"};
    constexpr std::uint64_t seed = 20261127;
    constexpr int places = 5;
    test::RandomSource random(seed);
    double worst = 0;
    for (const DrawnShape& shape : shapes())
    {
        std::vector<double> least = seen(shape.inside, random);
        std::vector<double> most = least;
        for (int place = 1; place < places; ++place)
        {
            const std::vector<double> now = seen(shape.inside, random);
            for (std::size_t k = 0; k < now.size(); ++k)
            {
                least[k] = std::min(least[k], now[k]);
                most[k] = std::max(most[k], now[k]);
            }
        }
        for (std::size_t k = 0; k < least.size(); ++k)
        {
            const double off = (most[k] - least[k]) / 2;
            const std::string name = k < names.size() ? names[k] : "D_" + std::to_string(k - names.size());
            EXPECT_LT(off, 1e-3) << shape.name << ": " << name << ", seed " << seed;
            worst = std::max(worst, off);
        }
    }
    test::record("grainsFromImages", "descriptorInvariancePixels", worst, "-");
}
