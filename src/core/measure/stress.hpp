#pragma once

#include "core/base/setupError.hpp"
#include "core/contact/contact.hpp"
#include "core/dynamics/bodies.hpp"

#include <Eigen/Core>

#include <cmath>
#include <optional>
#include <vector>

namespace chesil
{

/// From the first body's centroid to the second's, to the contact point if that is a wall [m]. Of no use
/// across a periodic boundary.
inline Vector2 branchVector(const Contact<2>& contact, const Bodies<2>& bodies)
{
    const Vector2& end = contact.withWall() ? contact.point : bodies.pose[contact.second].position;
    return end - bodies.pose[contact.first].position;
}

/// Mean stress of a region [N/m2], compression positive, row the branch, column the force:
///   sigma = -1/area  sum over contacts of  branch (x) force on the first body.
/// The mean of a tension-positive stress over a body in balance is 1/area sum x (x) t over the forces t on
/// its boundary. A contact at c puts f on the first body and -f on the second: (c - x1) (x) f - (c - x2) (x)
/// f = (x2 - x1) (x) f, the contact point drops out, and compression (f against the branch) comes out
/// negative; hence the minus. A wall has no second grain: its branch ends at c (Love-Weber; Christoffersen,
/// Mehrabadi & Nemat-Nasser 1981).
///
/// `branch(contact)` gives the vector from first's to second's centroid, with walls to the contact point [m]:
/// the nearest image in a periodic cell, and only the part within the region if the region cuts it. Every
/// contact point counts, so that both ends of a flat contact add their forces. Not symmetric as far as the
/// grains' torques are not balanced; without the kinetic part m v (x) v. Zero without contacts. Throws
/// ValueError if the area [m2] is not positive and finite.
template <typename Branch>
Eigen::Matrix2d meanStress(const std::vector<Contact<2>>& contacts, const Branch& branch, double area)
{
    if (!(area > 0 && std::isfinite(area)))
    {
        throw ValueError("area " + numberText(area), "a positive, finite one");
    }
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const Contact<2>& contact : contacts)
    {
        if (contact.depth > 0)
        {
            sum -= Vector2(branch(contact)) * contact.force.transpose();
        }
    }
    return sum / area;
}

/// Sum of what the grains do to a wall [N].
Vector2 forceOnWall(const std::vector<Contact<2>>& contacts, std::size_t wall);

/// [N/m2].
struct WallStress
{
    /// Compression positive.
    double normal = 0;
    /// Along the outward normal turned by +90 degrees, as the grains pull the wall.
    double shear = 0;
};

/// What the force on a wall [N] makes on its length [m]; `wallNormal` is the wall's own, into the domain.
/// Under a uniform symmetric stress: normal = n.sigma.n, shear = n.sigma.t with the outward n and t = n
/// turned by +90 degrees. Throws ValueError if the length is not positive and finite.
WallStress wallStress(const Vector2& force, const Vector2& wallNormal, double length);

/// What is said of a plane stress tensor, from its symmetric part; compression positive [N/m2].
struct StressMeasures
{
    /// (major + minor)/2.
    double mean = 0;
    /// (major - minor)/2, half of the difference that some call q; deviatoric/mean is the sine of the
    /// mobilised friction.
    double deviatoric = 0;
    double major = 0;
    double minor = 0;
    /// Of the major principal stress, in [0, pi) [rad]; the minor stands across. Nothing if exactly
    /// isotropic.
    std::optional<double> direction;
    /// asin((major - minor)/(major + minor)) [rad]. Nothing if the mean is not positive or the minor is
    /// negative: no angle of friction holds that. A chain in one direction has minor 0 and may round to
    /// either side.
    std::optional<double> mobilisedFriction;
};

StressMeasures stressMeasures(const Eigen::Matrix2d& stress);

} // namespace chesil
