#pragma once

#include <array>

namespace chesil
{

struct GaussPoint
{
    double abscissa;
    double weight;
};

/// Gauss-Legendre rule with 6 points on [-1, 1], exact up to degree 11 (Abramowitz & Stegun, table 25.4): the points
/// of positive abscissa, to be taken with both signs.
constexpr std::array<GaussPoint, 3> halfRule{{
    {0.238619186083196908630501721681, 0.467913934572691047389870343990},
    {0.661209386466264513661399595020, 0.360761573048138607569833513838},
    {0.932469514203152027812301554494, 0.171324492379170345040296142173},
}};

/// Calls function(t, weight) for the rule's points on [from, to]; the weights sum to to - from.
template <class Function>
void forGaussPoints(double from, double to, const Function& function)
{
    for (const GaussPoint& gauss : halfRule)
    {
        for (const double sign : {-1.0, 1.0})
        {
            function(from + (to - from) * 0.5 * (1 + sign * gauss.abscissa), 0.5 * (to - from) * gauss.weight);
        }
    }
}

} // namespace chesil
