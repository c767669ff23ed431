#pragma once

#include <algorithm>

namespace chesil
{

/// Spring of rolling resistance over the contact's normal stiffness and the square of friction times radius: Jiang, Yu &
/// Harris (2005), model C of Ai, Chen, Rotter & Ooi (2011).
constexpr double rollingStiffness = 2.25;

/// Torque [N m] on the first body in the plane, against its turning relative to the second. `turned` is the elastic
/// relative rotation [rad], carried from step to step: it grows by this step's relative spin [rad/s] and is cut to what
/// the friction (times radius [m], 1/(1/r1 + 1/r2) of the disks of equal area, and pressing force [N]) holds. `loss`, if not null, grows by what yielding takes
/// [J].
inline double rollingTorque(
    double friction, double radius, double pressing, double normalStiffness, double relativeSpin, double timeStep, double& turned,
    double* loss = nullptr)
{
    const double arm = friction * radius;
    const double stiffness = rollingStiffness * normalStiffness * arm * arm;
    const double most = arm * pressing;
    const double before = turned;
    turned += timeStep * relativeSpin;
    const double elastic = -stiffness * turned;
    const double torque = std::max(-most, std::min(elastic, most));
    if (torque != elastic)
    {
        if (loss)
        {
            *loss += (stiffness * before - torque) / 2 * (turned + torque / stiffness);
        }
        turned = -torque / stiffness;
    }
    return torque;
}

} // namespace chesil
