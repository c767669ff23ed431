#include "core/measure/unbalanced.hpp"

#include "core/base/setupError.hpp"

#include <algorithm>
#include <string>

namespace chesil
{

namespace
{

/// [N]; 0 without contacts.
double meanContactForce(const std::vector<Contact<2>>& contacts)
{
    double sum = 0;
    std::size_t count = 0;
    for (const Contact<2>& contact : contacts)
    {
        if (contact.depth > 0)
        {
            sum += contact.force.norm();
            ++count;
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0;
}

} // namespace

std::optional<UnbalancedForce> unbalancedForce(const std::vector<Vector2>& force,
                                               const std::vector<double>& inverseMass,
                                               const std::vector<Contact<2>>& contacts)
{
    if (force.size() != inverseMass.size())
    {
        throw ValueError(std::to_string(force.size()) + " forces for " + std::to_string(inverseMass.size()) +
                             " grains",
                         "as many");
    }
    double largest = 0;
    double sum = 0;
    std::size_t moving = 0;
    for (std::size_t i = 0; i < force.size(); ++i)
    {
        if (inverseMass[i] > 0)
        {
            const double size = force[i].norm();
            largest = std::max(largest, size);
            sum += size;
            ++moving;
        }
    }
    const double contactForce = meanContactForce(contacts);
    if (moving == 0 || !(contactForce > 0))
    {
        return std::nullopt;
    }
    return UnbalancedForce{largest / contactForce, sum / static_cast<double>(moving) / contactForce};
}

} // namespace chesil
