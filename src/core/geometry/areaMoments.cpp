#include "core/geometry/areaMoments.hpp"

#include <array>

namespace chesil
{

namespace
{

struct GaussPoint
{
    double abscissa;
    double weight;
};

/// Gauss-Legendre rule with 6 points on [-1, 1] (Abramowitz & Stegun, table 25.4).
constexpr std::array<GaussPoint, 3> halfRule{{
    {0.238619186083196908630501721681, 0.467913934572691047389870343990},
    {0.661209386466264513661399595020, 0.360761573048138607569833513838},
    {0.932469514203152027812301554494, 0.171324492379170345040296142173},
}};

} // namespace

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
    for (const GaussPoint& gauss : halfRule)
    {
        for (const double sign : {-1.0, 1.0})
        {
            const double t = 0.5 * (1 + sign * gauss.abscissa);
            const Vector2 x = segment.at(t);
            const double swept = 0.5 * gauss.weight * cross(x, segment.derivative(t));
            moments.area += swept / 2;
            moments.first += x * (swept / 3);
            moments.polar += x.squaredNorm() * swept / 4;
        }
    }
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
