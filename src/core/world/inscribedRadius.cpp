#include "core/world/inscribedRadius.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

double inscribedRadius(const Shape& shape)
{
    constexpr int directions = 720;
    double least = boundingRadius(shape);
    for (int i = 0; i < directions; ++i)
    {
        const double angle = 2 * M_PI * i / directions;
        const Vector2 direction(std::cos(angle), std::sin(angle));
        least = std::min(least, support(shape, direction).dot(direction));
    }
    return least;
}

} // namespace chesil
