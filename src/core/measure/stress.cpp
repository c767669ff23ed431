#include "core/measure/stress.hpp"

#include "core/measure/axialData.hpp"

namespace chesil
{

Vector2 forceOnWall(const std::vector<Contact<2>>& contacts, std::size_t wall)
{
    Vector2 sum = Vector2::Zero();
    for (const Contact<2>& contact : contacts)
    {
        if (contact.depth > 0 && contact.second == Contact<2>::wallAsSecond(wall))
        {
            sum -= contact.force;
        }
    }
    return sum;
}

WallStress wallStress(const Vector2& force, const Vector2& wallNormal, double length)
{
    if (!(length > 0 && std::isfinite(length)))
    {
        throw ValueError("length " + numberText(length), "a positive, finite one");
    }
    const Vector2 outward = -wallNormal;
    return {force.dot(outward) / length, force.dot(perpendicular(outward)) / length};
}

StressMeasures stressMeasures(const Eigen::Matrix2d& stress)
{
    const SecondHarmonic deviator{0.5 * (stress(0, 0) - stress(1, 1)), 0.5 * (stress(0, 1) + stress(1, 0))};
    StressMeasures measures;
    measures.mean = 0.5 * stress.trace();
    measures.deviatoric = deviator.amplitude();
    measures.major = measures.mean + measures.deviatoric;
    measures.minor = measures.mean - measures.deviatoric;
    measures.direction = deviator.direction();
    if (measures.mean > 0 && measures.deviatoric <= measures.mean)
    {
        measures.mobilisedFriction = std::asin(measures.deviatoric / measures.mean);
    }
    return measures;
}

} // namespace chesil
