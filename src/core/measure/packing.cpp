#include "core/measure/packing.hpp"

#include "core/base/setupError.hpp"

#include <cmath>

namespace chesil
{

Packing packing(const std::vector<double>& grainAreas, double regionArea)
{
    if (!(regionArea > 0 && std::isfinite(regionArea)))
    {
        throw ValueError("region of area " + numberText(regionArea), "a positive, finite one");
    }
    double solid = 0;
    for (const double area : grainAreas)
    {
        if (!(area >= 0 && std::isfinite(area)))
        {
            throw ValueError("grain of area " + numberText(area), "a finite one, not negative");
        }
        solid += area;
    }
    Packing result;
    result.solidFraction = solid / regionArea;
    if (solid > 0)
    {
        result.voidRatio = (regionArea - solid) / solid;
    }
    return result;
}

} // namespace chesil
