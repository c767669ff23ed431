#pragma once

#include "generate/image/silhouette.hpp"
#include "unit/randomGrain.hpp"

#include <cmath>
#include <string>
#include <vector>

/// Shapes drawn to pixels for tests: a pixel is dark if its centre lies in the shape.
namespace chesil::test
{

/// `inside(point)` tells whether a point [pixel] of the box width x height is in the shape.
template <class Inside>
Silhouette drawn(int width, int height, const Inside& inside)
{
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            pixels.push_back(inside(Vector2(x + 0.5, y + 0.5)) ? 1 : 0);
        }
    }
    return Silhouette(width, height, std::move(pixels));
}

/// An ellipse at any angle [pixel].
struct DrawnEllipse
{
    Vector2 centre;
    double a;
    double b;
    Rotation<2> turn;

    bool operator()(const Vector2& point) const
    {
        const Vector2 local = turn.applyInverse(point - centre);
        return std::hypot(local.x() / a, local.y() / b) <= 1;
    }

    double area() const { return M_PI * a * b; }
    int boxSize() const { return static_cast<int>(2 * a) + 6; }
};

/// With the longer half-axis between `least` and `most` [pixel] and an axis ratio of 0.4 to 1.
inline DrawnEllipse randomEllipse(double least, double most, RandomSource& random)
{
    const double a = random.uniform(least, most);
    const double b = a * random.uniform(0.4, 1);
    const Vector2 centre(a + 2 + random.uniform(0, 1), a + 2 + random.uniform(0, 1));
    return {centre, a, b, Rotation<2>(random.uniform(0, M_PI))};
}

} // namespace chesil::test
