#pragma once

#include "core/measure/axialData.hpp"
#include "core/measure/measuredContact.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace chesil
{

/// Fabric tensor of contact normals, 1/N sum of n (x) n (Satake 1982), with trace 1, world frame. Counts
/// contact points: a flat contact's two ends are two. Nothing without contacts.
std::optional<Eigen::Matrix2d> fabricTensor(const std::vector<Contact<2>>& contacts, WallContacts walls);

/// Anisotropy of the normals, a = 2 (major - minor), and direction, that of the major principal value. It is
/// the amplitude a of the density of directions E(t) = (1 + a cos 2(t - t_a))/(2 pi), whose tensor has the
/// principal values 1/2 + a/4 and 1/2 - a/4; other harmonics do not change it. From 0 to 2 (all normals along
/// one line).
SecondHarmonic fabricAnisotropy(const Eigen::Matrix2d& fabric);

/// How far averages by direction could be formed.
enum class DirectionalStatus
{
    fitted,
    /// All averages are zero.
    noContacts,
    /// The normals' amplitude is 1 or more: the fitted density is not positive in all directions, so that it
    /// cannot weigh the forces. Only the normals' harmonic is set.
    densityNotPositive,
    /// The mean normal force is not positive. Only it and the normals' harmonic are set.
    noNormalForce
};

/// Contact normals and forces by direction t, as Fourier series (Rothenburg & Bathurst 1989):
///   density          E(t) = (1 + a cos 2(t - t_a))/(2 pi),
///   normal force     fn(t) = f0 (1 + a_n cos 2(t - t_n)), positive in compression,
///   tangential force ft(t) = -f0 a_t sin 2(t - t_t), along the normal turned by +90 degrees.
struct DirectionalAverages
{
    DirectionalStatus status = DirectionalStatus::noContacts;
    /// a and t_a.
    SecondHarmonic normals;
    /// f0 [N]: mean over directions, not over contacts.
    double normalForce = 0;
    /// a_n and t_n; a_t and t_t.
    SecondHarmonic normalForces;
    SecondHarmonic tangentialForces;

    /// deviatoric/mean stress that follows for equal branches along the normals, to first order in the
    /// amplitudes. If the three directions agree it is (a + a_n + a_t)/2, else the amplitude of the
    /// harmonics' sum over 2. The exact ratio of agreeing directions is this over 1 + a a_n/2. Nothing
    /// unless fitted.
    std::optional<double> stressRatio() const;
};

/// From the Fourier integrals over directions, as sums over contacts: int g(t) dt/(2 pi) is the mean of g/(2
/// pi E) over contacts, with the fitted E. That E has other harmonics than the second is neglected there.
/// Counts contact points: each of a flat contact's two ends has its own force. No bins.
DirectionalAverages directionalAverages(const std::vector<Contact<2>>& contacts, WallContacts walls);

} // namespace chesil
