#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace chesil::benchmark
{

/// What a series, sampled evenly, does in the long run.
struct Drift
{
    /// Least-squares slope times the length of the series.
    double change = 0;
    /// Mean increment from one of `parts` to the next over its standard error: |t| of about 1 for a random walk, which
    /// the errors of single collisions add up to, and growing with the root of the length for a true drift. The slope's own
    /// standard error will not do: it takes the samples as independent, and finds a drift in any random walk.
    double significance = 0;
};

/// `values` at least as many as `parts` + 1; 0 if they are all the same.
inline Drift driftOf(const std::vector<double>& values, std::size_t parts = 20)
{
    const double count = static_cast<double>(values.size());
    double slope = 0;
    double sumXX = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        const double x = static_cast<double>(i) - (count - 1) / 2;
        slope += x * values[i];
        sumXX += x * x;
    }
    const auto at = [&](std::size_t part) { return values[part * (values.size() - 1) / parts]; };
    const double n = static_cast<double>(parts);
    const double mean = (at(parts) - at(0)) / n;
    double squares = 0;
    for (std::size_t part = 0; part < parts; ++part)
    {
        squares += std::pow(at(part + 1) - at(part) - mean, 2);
    }
    const double error = std::sqrt(squares / (n - 1) / n);
    return {slope / sumXX * count, error > 0 ? mean / error : 0};
}

} // namespace chesil::benchmark
