#include "core/measure/fabric.hpp"

namespace chesil
{

namespace
{

/// cos 2t and sin 2t of a unit vector's direction t.
SecondHarmonic doubled(const Vector2& normal)
{
    return {normal.x() * normal.x() - normal.y() * normal.y(), 2 * normal.x() * normal.y()};
}

/// Sums over contacts, each weighted by the inverse of the density of its direction.
struct WeightedSums
{
    std::size_t contacts = 0;
    double normalForce = 0;
    SecondHarmonic normalForces;
    SecondHarmonic tangentialForces;
};

WeightedSums weightedSums(const std::vector<Contact<2>>& contacts, WallContacts walls,
                          const SecondHarmonic& density)
{
    WeightedSums sums;
    for (const Contact<2>& contact : contacts)
    {
        if (!isMeasured(contact, walls))
        {
            continue;
        }
        ++sums.contacts;
        const SecondHarmonic at = doubled(contact.normal);
        const double weight = 1 / (1 + density.cosine * at.cosine + density.sine * at.sine);
        const double normal = weight * normalForce(contact);
        sums.normalForce += normal;
        sums.normalForces.cosine += normal * at.cosine;
        sums.normalForces.sine += normal * at.sine;
        // -sin 2(t - t_t) = -sin 2t cos 2t_t + cos 2t sin 2t_t
        const double tangential = weight * tangentialForce(contact);
        sums.tangentialForces.cosine -= tangential * at.sine;
        sums.tangentialForces.sine += tangential * at.cosine;
    }
    return sums;
}

SecondHarmonic scaled(const SecondHarmonic& harmonic, double factor)
{
    return {factor * harmonic.cosine, factor * harmonic.sine};
}

} // namespace

std::optional<Eigen::Matrix2d> fabricTensor(const std::vector<Contact<2>>& contacts, WallContacts walls)
{
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    std::size_t count = 0;
    for (const Contact<2>& contact : contacts)
    {
        if (isMeasured(contact, walls))
        {
            sum += contact.normal * contact.normal.transpose();
            ++count;
        }
    }
    if (count == 0)
    {
        return std::nullopt;
    }
    return sum / static_cast<double>(count);
}

SecondHarmonic fabricAnisotropy(const Eigen::Matrix2d& fabric)
{
    return {2 * (fabric(0, 0) - fabric(1, 1)), 2 * (fabric(0, 1) + fabric(1, 0))};
}

std::optional<double> DirectionalAverages::stressRatio() const
{
    if (status != DirectionalStatus::fitted)
    {
        return std::nullopt;
    }
    return 0.5 * SecondHarmonic{normals.cosine + normalForces.cosine + tangentialForces.cosine,
                                normals.sine + normalForces.sine + tangentialForces.sine}
                     .amplitude();
}

DirectionalAverages directionalAverages(const std::vector<Contact<2>>& contacts, WallContacts walls)
{
    DirectionalAverages averages;
    const std::optional<Eigen::Matrix2d> fabric = fabricTensor(contacts, walls);
    if (!fabric)
    {
        return averages;
    }
    averages.normals = fabricAnisotropy(*fabric);
    if (!(averages.normals.amplitude() < 1))
    {
        averages.status = DirectionalStatus::densityNotPositive;
        return averages;
    }

    const WeightedSums sums = weightedSums(contacts, walls, averages.normals);
    averages.normalForce = sums.normalForce / static_cast<double>(sums.contacts);
    if (!(averages.normalForce > 0))
    {
        averages.status = DirectionalStatus::noNormalForce;
        return averages;
    }
    averages.status = DirectionalStatus::fitted;
    averages.normalForces = scaled(sums.normalForces, 2 / sums.normalForce);
    averages.tangentialForces = scaled(sums.tangentialForces, 2 / sums.normalForce);
    return averages;
}

} // namespace chesil
