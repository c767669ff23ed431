#include "core/world/resultantForces.hpp"

namespace chesil
{

std::vector<Vector2> resultantForces(const World& world)
{
    std::vector<Vector2> forces;
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
        forces.push_back(world.weightOf(i));
    }
    for (const Contact<2>& contact : world.contacts())
    {
        if (contact.depth > 0)
        {
            forces[static_cast<std::size_t>(contact.first)] += contact.force;
            if (!contact.withWall())
            {
                forces[static_cast<std::size_t>(contact.second)] -= contact.force;
            }
        }
    }
    return forces;
}

} // namespace chesil
