#pragma once

#include "benchmarks/paperKernel/contactPair.hpp"
#include "benchmarks/paperKernel/table.hpp"

namespace chesil::benchmark
{

constexpr int rounds = 31;
/// Of all pairs in one reading of the clock, which counts microseconds.
constexpr int repetitions = 4;

struct Curve
{
    const char* name;
    Method method;
    std::vector<const ContactPair*> pairs;
};

inline double quantile(std::vector<double> values, double share)
{
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// Decimal orders that an iteration takes off, by least squares over the residuals that are neither the start
/// nor rounding; 0 if those are less than six.
inline double ordersAnIteration(const std::vector<double>& medians)
{
    std::vector<double> exponentials;
    std::vector<double> residuals;
    for (std::size_t k = 0; k < medians.size(); ++k)
    {
        if (medians[k] < handOver && medians[k] > 1e-14)
        {
            exponentials.push_back(std::exp(static_cast<double>(k)));
            residuals.push_back(medians[k]);
        }
    }
    return residuals.size() < 6 ? 0 : -logarithmicSlope(exponentials, residuals) / std::log(10.0);
}

/// CPU time [ns] a pair of 1, 2, ... calls.
inline std::vector<double> timesOf(const Curve& curve)
{
    std::vector<std::function<double()>> works;
    for (int calls = 1; calls <= mostCalls; ++calls)
    {
        works.push_back(
            [&curve, calls]()
            {
                double sum = 0;
                for (int repetition = 0; repetition < repetitions; ++repetition)
                {
                    for (const ContactPair* pair : curve.pairs)
                    {
                        sum += pair->follow(curve.method, calls)[0];
                    }
                }
                return sum;
            });
    }
    std::vector<double> times = medianSeconds(works, rounds);
    for (double& time : times)
    {
        time *= 1e9 / (repetitions * static_cast<double>(curve.pairs.size()));
    }
    return times;
}

inline void measureCurve(const Curve& curve, Table& table, Results& results)
{
    std::array<std::vector<double>, mostCalls> residuals;
    std::vector<int> callsToTwelve;
    int lost = 0;
    for (const ContactPair* pair : curve.pairs)
    {
        const Residuals ofPair = pair->follow(curve.method, mostCalls);
        for (std::size_t k = 0; k < mostCalls; ++k)
        {
            residuals[k].push_back(ofPair[k]);
        }
        const auto reached = std::find_if(ofPair.begin(), ofPair.end(), [](double r) { return r <= 1e-12; });
        lost += reached == ofPair.end();
        callsToTwelve.push_back(static_cast<int>(reached - ofPair.begin()) + 1);
    }
    const std::vector<double> times = timesOf(curve);
    std::vector<double> medians;
    for (std::size_t k = 0; k < mostCalls; ++k)
    {
        medians.push_back(median(residuals[k]));
        table.row("%s,%zu,%.4g,%.4g,%.4g,%.4g,%zu", curve.name, k + 1, quantile(residuals[k], 0.1),
                  medians[k], quantile(residuals[k], 0.9), quantile(residuals[k], 1), curve.pairs.size());
        if (k == 0 || medians[k - 1] > floorOfResidual)
        {
            results.measurements.push_back({curve.name, std::to_string(k + 1), medians[k], times[k]});
        }
    }
    const double orders = ordersAnIteration(medians);
    const std::string fit =
        orders > 0 ? text("%9.2f  %8.2f", -10 * orders, std::pow(10, orders)) : text("%9s  %8s", "-", "-");
    std::printf("      %-26s  %5zu  %s  %9.1f  %6d\n", curve.name, curve.pairs.size(), fit.c_str(),
                mean(callsToTwelve), lost);
}

/// Fig. 15: the residuals of each curve and the time that they take.
inline void measureResiduals(const std::string& path, const std::vector<ContactPair>& contacts,
                             Results& results)
{
    std::vector<const ContactPair*> smooth, polyBeziers, others;
    for (const ContactPair& pair : contacts)
    {
        (pair.smooth() ? smooth : others).push_back(&pair);
        if (pair.bothPolyBezier())
        {
            polyBeziers.push_back(&pair);
        }
    }
    Table table(path, "method,iteration,low,median,high,worst,pairs");
    std::printf(
        "    Fig. 15, residual over support calls (paper: 1e-6 in 10; medians; fit from 1e-2 to 1e-14)\n");
    std::printf("      %-26s  %5s  %9s  %8s  %9s  %6s\n", "", "pairs", "log10, 10", "factor", "to 1e-12",
                "never");
    for (const Curve& curve : {Curve{"EPA polybezier pairs", Method::epa, polyBeziers},
                               Curve{"EPA smooth pairs", Method::epa, smooth},
                               Curve{"EPA pairs with a polygon", Method::epa, others},
                               Curve{"EPA to 1e-2 then Newton", Method::newtonAfterEpa, smooth},
                               Curve{"Newton from 1e-3 rad off", Method::newtonFromNear, smooth}})
    {
        measureCurve(curve, table, results);
    }
    table.close();
}

} // namespace chesil::benchmark
