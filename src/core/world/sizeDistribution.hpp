#pragma once

#include <variant>
#include <vector>

namespace chesil
{

/// Each distribution below is given by its quantile: the size below which a share p in [0, 1] of the grains'
/// number, or of their mass, lies. Sizes are diameters of the disk of the same area [m], unless the
/// distribution says otherwise.

/// By number: any ratio to the template's own size in [least, largest] is as likely. Throws ValueError unless
/// 0 < least <= largest.
class UniformRatio
{
public:
    UniformRatio(double least, double largest);

    double quantile(double p) const;

private:
    double least_;
    double largest_;
};

/// By number: ln(size) is normal about ln(median) with standard deviation `deviation` > 0, cut off below
/// `least` and above `largest`; what lies between counts as the whole. Throws ValueError if a value is not
/// positive, if the range is empty or if it holds less than 1e-6 of the distribution.
class LognormalSize
{
public:
    LognormalSize(double median, double deviation, double least, double largest);

    double quantile(double p) const;

private:
    double median_;
    double deviation_;
    double least_;
    double largest_;
    /// Normal probabilities of the two ends; both counted from the other side if the range lies above the
    /// median, where those from below are near 1 and have lost their digits.
    double lowerShare_;
    double upperShare_;
    bool mirrored_;
};

/// By mass: share `passing` of the mass is finer than `sizes`, from 0 at the first to 1 at the last, straight
/// between them over the logarithm of the size. Throws ValueError unless there are two points at least, sizes
/// rise from above 0, and passing never falls.
class SieveCurve
{
public:
    SieveCurve(std::vector<double> sizes, std::vector<double> passing);

    double quantile(double p) const;

    const std::vector<double>& passing() const { return passing_; }

private:
    std::vector<double> sizes_;
    std::vector<double> passing_;
};

using SizeDistribution = std::variant<UniformRatio, LognormalSize, SieveCurve>;

/// Grains of one size and their share of the number.
struct SizeClass
{
    double size = 0;
    double share = 0;
};

/// Sizes in rising order; shares sum to 1. None: templates keep their size.
struct SizeClasses
{
    std::vector<SizeClass> classes;
    /// Sizes are ratios to the template's own, not diameters [m].
    bool areRatios = false;
};

/// `count` >= 1 classes of equal shares, each with the size at the middle of its share. A sieve curve's
/// classes are of equal mass and are cut at its points too, so that the mass below each of these is exact;
/// their shares by number follow from mass over the square of the size (grains are plane).
SizeClasses sizeClasses(const SizeDistribution& distribution, int count);

/// The normal distribution's quantile, in standard deviations from the mean; 0 < p < 1, relative error about
/// 1e-16. Source: Wichura, algorithm AS 241 (PPND16), Applied Statistics 37 (1988) 477-484.
double normalQuantile(double p);

} // namespace chesil
