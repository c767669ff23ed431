#pragma once

#include "core/contact/contactState.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

/// Hertz's normal force between smooth elastic bodies, Mindlin's stiffness against slip and Coulomb friction, with the dashpots
/// of Tsuji, Tanaka & Ishida (1992), which give one restitution at any speed:
///
///     F = (4/3) E sqrt(R) d^(3/2),    k_n = 2 E sqrt(R d),    k_t = 8 G sqrt(R d)
///
/// with 1/E = sum (1 - nu^2)/E_i, 1/G = sum (2 - nu)/G_i, R from the radii of curvature of both outlines. A force
/// between two points of contact [N], not per depth. The tangential force keeps its size while k_t grows and
/// shrinks with k_t, so that loading and unloading do not make energy (Thornton, Cummins & Cleary 2011).
struct HertzMindlinLaw
{
    static constexpr const char* typeName = "hertzMindlin";
    static constexpr bool usesCurvature = true;
    /// Whether the dashpot's coefficient is there from the first touch on; else it grows with the depth.
    static constexpr bool dampsAtOnce = false;
    /// x = d^(5/4) is a linear oscillator in the time s, ds = sqrt(5/4) d^(1/4) dt, that lets go where the force changes its
    /// sign (Antypov & Elliott 2011), so that restitutionOf holds with this factor.
    static constexpr double dampingFactor = 0.91287092917527685576; // sqrt(5/6)
    static constexpr double energyShare = 0.4;
    /// Overlap over the effective radius up to which the stable step holds; beyond it Hertz's theory does not, either.
    static constexpr double mostOverlap = 0.1;

    /// E and G above [Pa] > 0.
    double effectiveModulus = 0;
    double effectiveShearModulus = 0;
    /// As LinearLaw's.
    double friction = 0;
    double dampingRatio = 0;
    double cohesion = 0;
    double rollingFriction = 0;
    /// Energy that it takes to part the two surfaces, >= 0 [J/m2]: twice the surface energy of two like bodies.
    double workOfAdhesion = 0;

    bool frictional() const { return friction > 0; }

    double largestStiffness(double radius) const
    {
        return std::max(2 * effectiveModulus, 8 * effectiveShearModulus) * radius * std::sqrt(mostOverlap);
    }

    /// What draws the two bodies together while they touch [N]: cohesion, and the pull-off force 2 pi w R of two stiff
    /// spheres, which keeps its size at any depth (Derjaguin, Muller & Toporov 1975; Maugis 1992).
    template <int Dim>
    double attraction(const ContactState<Dim>& contact) const
    {
        return cohesion + 2 * M_PI * workOfAdhesion * contact.effectiveRadius;
    }

    template <int Dim>
    ContactSprings springs(const ContactState<Dim>& contact) const
    {
        const double root = std::sqrt(contact.effectiveRadius * contact.depth);
        return {
            4.0 / 3.0 * effectiveModulus * root * contact.depth,
            2 * effectiveModulus * root,
            8 * effectiveShearModulus * root,
            std::sqrt(contact.previousDepth / contact.depth)};
    }
};

/// The moduli of a pair of materials: Young's modulus [Pa] > 0 and Poisson's ratio, -1 < nu <= 0.5, of each.
struct ElasticMaterial
{
    double youngsModulus;
    double poissonsRatio;
};

inline double effectiveModulusOf(const ElasticMaterial& a, const ElasticMaterial& b)
{
    const auto compliance = [](const ElasticMaterial& m) { return (1 - m.poissonsRatio * m.poissonsRatio) / m.youngsModulus; };
    return 1 / (compliance(a) + compliance(b));
}

inline double effectiveShearModulusOf(const ElasticMaterial& a, const ElasticMaterial& b)
{
    // (2 - nu)/G with G = E/(2 (1 + nu)).
    const auto compliance = [](const ElasticMaterial& m)
    { return 2 * (2 - m.poissonsRatio) * (1 + m.poissonsRatio) / m.youngsModulus; };
    return 1 / (compliance(a) + compliance(b));
}

} // namespace chesil
