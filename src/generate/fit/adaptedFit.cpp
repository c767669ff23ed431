#include "generate/fit/adaptedFit.hpp"

#include <algorithm>

namespace chesil
{

namespace
{

/// Distances that pixels do not tell from 0, in pixels: a corner within them stays.
constexpr double unseen = 0.1;

/// The segment with the largest area between it and the polygon that is not straight; their number if all
/// are.
std::size_t worstSegment(const OutlineFit& fit, const JointPlan& plan)
{
    std::size_t worst = fit.segments.size();
    for (std::size_t i = 0; i < fit.segments.size(); ++i)
    {
        const bool isWorse = worst == fit.segments.size() || fit.areas[i] > fit.areas[worst];
        worst = isWorse && !plan.joints()[i].straightAfter ? i : worst;
    }
    return worst;
}

} // namespace

OutlineFit fitWithCorners(const std::vector<Vector2>& polygon, int segments, double pixel)
{
    requireFittable(polygon, segments);
    const JointPlan plan = JointPlan::adapted(polygon, segments, pixel);
    const std::optional<OutlineFit> cornered = fitAtJoints(polygon, plan);
    if (cornered && plan.corners() == 0)
    {
        return *cornered;
    }
    const OutlineFit smooth = fitWithoutCorners(polygon, JointPlan::adapted(polygon, segments, 0));
    return cornered && cornered->distance <= std::max(smooth.distance, unseen * pixel) ? *cornered : smooth;
}

OutlineFit fitToAccuracy(const std::vector<Vector2>& polygon, int most, double pixel,
                         const std::function<bool(const std::vector<CubicBezier>&)>& isGoodEnough)
{
    requireFittable(polygon, most);
    JointPlan plan = JointPlan::coarsest(polygon, most, pixel);
    while (true)
    {
        const std::optional<OutlineFit> atJoints = fitAtJoints(polygon, plan);
        if (!atJoints && plan.corners() > 0)
        {
            plan = JointPlan::coarsest(polygon, most, 0);
            continue;
        }
        const OutlineFit split = atJoints ? *atJoints : fitWithoutCorners(polygon, plan);
        const int segments = static_cast<int>(split.segments.size());
        const std::size_t worst = worstSegment(split, plan);
        if (isGoodEnough(split.segments) || worst == split.segments.size())
        {
            return split;
        }
        const OutlineFit spread = fitWithCorners(polygon, segments, pixel);
        if (isGoodEnough(spread.segments) || segments >= most)
        {
            return isGoodEnough(spread.segments) || spread.distance < split.distance ? spread : split;
        }
        plan.split(worst);
    }
}

} // namespace chesil
