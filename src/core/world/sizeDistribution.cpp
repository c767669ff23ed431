#include "core/world/sizeDistribution.hpp"

#include "core/base/setupError.hpp"

#include <algorithm>
#include <cmath>

namespace chesil
{

namespace
{

constexpr double leastShareInRange = 1e-6;
/// Cuts of the sieve curve nearer to each other than this share of the mass are one.
constexpr double sameShare = 1e-9;

void requirePositive(double value, const char* what)
{
    if (!(value > 0 && std::isfinite(value)))
    {
        throw ValueError(std::string(what) + " " + numberText(value), "a finite number > 0");
    }
}

void requireRange(double least, double largest)
{
    requirePositive(least, "a least size of");
    requirePositive(largest, "a largest size of");
    if (least > largest)
    {
        throw ValueError("sizes from " + numberText(least) + " to " + numberText(largest),
                         "the least one not above the largest one");
    }
}

/// Share of a normal distribution below z standard deviations.
double normalShare(double z) { return std::erfc(-z * std::sqrt(0.5)) / 2; }

void requireSieve(const std::vector<double>& sizes, const std::vector<double>& passing)
{
    if (sizes.size() < 2 || sizes.size() != passing.size())
    {
        throw ValueError(std::to_string(sizes.size()) + " sizes and " + std::to_string(passing.size()) +
                             " values of passing",
                         "as many of both, two at least");
    }
    requirePositive(sizes.front(), "a sieve size of");
    requirePositive(sizes.back(), "a sieve size of");
    for (std::size_t i = 1; i < sizes.size(); ++i)
    {
        if (!(sizes[i] > sizes[i - 1]))
        {
            throw ValueError("sieve size " + numberText(sizes[i]) + " after " + numberText(sizes[i - 1]),
                             "sizes that rise");
        }
        if (!(passing[i] >= passing[i - 1]))
        {
            throw ValueError("passing " + numberText(passing[i]) + " after " + numberText(passing[i - 1]),
                             "shares that never fall");
        }
    }
    if (passing.front() != 0 || passing.back() != 1)
    {
        throw ValueError("passing from " + numberText(passing.front()) + " to " + numberText(passing.back()),
                         "shares of the mass from 0 (at the least size) to 1 (at the largest)");
    }
}

/// Shares of the mass at which classes of a sieve curve end: multiples of 1/count and the curve's own points.
std::vector<double> massCuts(const SieveCurve& curve, int count)
{
    std::vector<double> cuts = curve.passing();
    for (int i = 1; i < count; ++i)
    {
        cuts.push_back(static_cast<double>(i) / count);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end(), [](double a, double b) { return b - a < sameShare; }),
               cuts.end());
    cuts.back() = 1;
    return cuts;
}

template <class Distribution>
std::vector<SizeClass> classesOf(const Distribution& distribution, int count)
{
    std::vector<SizeClass> classes;
    for (int i = 0; i < count; ++i)
    {
        classes.push_back({distribution.quantile((i + 0.5) / count), 1.0 / count});
    }
    return classes;
}

std::vector<SizeClass> classesOf(const SieveCurve& curve, int count)
{
    const std::vector<double> cuts = massCuts(curve, count);
    std::vector<SizeClass> classes;
    double sum = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
        const double size = curve.quantile((cuts[i - 1] + cuts[i]) / 2);
        const double number = (cuts[i] - cuts[i - 1]) / (size * size);
        classes.push_back({size, number});
        sum += number;
    }
    for (SizeClass& one : classes)
    {
        one.share /= sum;
    }
    return classes;
}

} // namespace

UniformRatio::UniformRatio(double least, double largest) : least_(least), largest_(largest)
{
    requireRange(least, largest);
}

double UniformRatio::quantile(double p) const { return least_ + p * (largest_ - least_); }

LognormalSize::LognormalSize(double median, double deviation, double least, double largest)
    : median_(median), deviation_(deviation), least_(least), largest_(largest)
{
    requirePositive(median, "a median of");
    requirePositive(deviation, "a deviation of");
    requireRange(least, largest);
    const double lower = std::log(least / median) / deviation;
    const double upper = std::log(largest / median) / deviation;
    mirrored_ = lower > 0;
    lowerShare_ = normalShare(mirrored_ ? -lower : lower);
    upperShare_ = normalShare(mirrored_ ? -upper : upper);
    const double inRange = std::abs(upperShare_ - lowerShare_);
    if (!(inRange >= leastShareInRange))
    {
        throw ValueError("sizes from " + numberText(least) + " to " + numberText(largest) + ", which hold " +
                             numberText(inRange) + " of the grains about the median " + numberText(median),
                         "a range that holds at least " + numberText(leastShareInRange) + " of them");
    }
}

double LognormalSize::quantile(double p) const
{
    const double share = lowerShare_ + p * (upperShare_ - lowerShare_);
    if (p <= 0 || share <= 0 || share >= 1)
    {
        return p < 0.5 ? least_ : largest_;
    }
    const double z = mirrored_ ? -normalQuantile(share) : normalQuantile(share);
    // Beyond the ends by rounding only.
    return std::clamp(median_ * std::exp(deviation_ * z), least_, largest_);
}

SieveCurve::SieveCurve(std::vector<double> sizes, std::vector<double> passing)
    : sizes_(std::move(sizes)), passing_(std::move(passing))
{
    requireSieve(sizes_, passing_);
}

double SieveCurve::quantile(double p) const
{
    const auto above = std::upper_bound(passing_.begin(), passing_.end() - 1, p);
    const auto i = static_cast<std::size_t>(above - passing_.begin());
    if (i == 0)
    {
        return sizes_.front();
    }
    const double rise = passing_[i] - passing_[i - 1];
    const double share = rise > 0 ? (p - passing_[i - 1]) / rise : 1;
    return sizes_[i - 1] * std::exp(share * std::log(sizes_[i] / sizes_[i - 1]));
}

SizeClasses sizeClasses(const SizeDistribution& distribution, int count)
{
    if (count < 1)
    {
        throw ValueError(std::to_string(count) + " classes", "one at least");
    }
    SizeClasses result;
    result.classes = std::visit([&](const auto& d) { return classesOf(d, count); }, distribution);
    result.areRatios = std::holds_alternative<UniformRatio>(distribution);
    return result;
}

} // namespace chesil
