#include "core/measure/polarHistogram.hpp"

#include "core/base/setupError.hpp"
#include "core/measure/axialData.hpp"

#include <cmath>

namespace chesil
{

std::vector<PolarBin> polarHistogram(const std::vector<Contact<2>>& contacts, std::size_t bins,
                                     WallContacts walls)
{
    if (bins == 0)
    {
        throw ValueError("0 bins", "at least 1");
    }
    std::vector<PolarBin> histogram(bins);
    std::size_t total = 0;
    for (const Contact<2>& contact : contacts)
    {
        if (!isMeasured(contact, walls))
        {
            continue;
        }
        PolarBin& bin = histogram[roseBin(std::atan2(contact.normal.y(), contact.normal.x()), bins)];
        ++total;
        ++bin.contacts;
        bin.normalForce = bin.normalForce.value_or(0) + normalForce(contact);
        bin.tangentialForce = bin.tangentialForce.value_or(0) + tangentialForce(contact);
    }
    const double fullTurn = 2 * M_PI / static_cast<double>(bins) * static_cast<double>(total);
    for (PolarBin& bin : histogram)
    {
        if (bin.contacts > 0)
        {
            const double count = static_cast<double>(bin.contacts);
            bin.density = count / fullTurn;
            *bin.normalForce /= count;
            *bin.tangentialForce /= count;
        }
    }
    return histogram;
}

} // namespace chesil
