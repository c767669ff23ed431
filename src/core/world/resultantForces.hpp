#pragma once

#include "core/world/world.hpp"

#include <vector>

namespace chesil
{

/// On each grain, of its weight and all its contacts [N]: what moves it, before local and viscous damping, which
/// `Bodies::force` holds the sum of already. Without loads from outside (World::setExternalLoads). Of the last step.
std::vector<Vector2> resultantForces(const World& world);

} // namespace chesil
