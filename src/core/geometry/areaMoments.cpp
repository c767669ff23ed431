#include "core/geometry/areaMoments.hpp"

#include "core/geometry/gaussRule.hpp"

namespace chesil
{

AreaMoments& AreaMoments::operator+=(const AreaMoments& other)
{
    area += other.area;
    first += other.first;
    polar += other.polar;
    return *this;
}

AreaMoments boundaryMoments(const CubicBezier& segment)
{
    AreaMoments moments;
    const auto add = [&](double t, double weight)
    {
        const Vector2 x = segment.at(t);
        const double swept = weight * cross(x, segment.derivative(t));
        moments.area += swept / 2;
        moments.first += x * (swept / 3);
        moments.polar += x.squaredNorm() * swept / 4;
    };
    forGaussPoints(0, 1, add);
    return moments;
}

AreaMoments regionMoments(const std::vector<CubicBezier>& boundary)
{
    AreaMoments moments;
    for (const CubicBezier& segment : boundary)
    {
        moments += boundaryMoments(segment);
    }
    return moments;
}

} // namespace chesil
