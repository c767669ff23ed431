#include "core/shapes/longAxis.hpp"

#include "core/base/tolerances.hpp"
#include "core/geometry/secondMoments.hpp"

#include <cmath>

namespace chesil
{

std::optional<double> longAxis(const Shape& shape)
{
    const Eigen::Matrix2d moments = secondMoments(outline(shape));
    const double along = moments(0, 0) - moments(1, 1);
    const double aslant = moments(0, 1) + moments(1, 0);
    if (!(std::hypot(along, aslant) > tolerances::isotropic * moments.trace()))
    {
        return std::nullopt;
    }
    return 0.5 * std::atan2(aslant, along);
}

} // namespace chesil
