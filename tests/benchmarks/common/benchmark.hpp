#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// What the programs of tests/benchmarks share: a clock, medians, and the table that they write.
namespace chesil::benchmark
{

/// CPU time of this process [s]. For one thread it is the run time, less what a busy machine gave to others.
inline double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Keeps the optimiser from removing the work that led to a value.
inline void keep(double value)
{
    static volatile double kept = 0;
    kept = value;
    static_cast<void>(kept);
}

inline double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Median CPU time [s] of each piece of work over `rounds`, after one round to warm up. All pieces take
/// their turn in every round, so that a drift of the machine's speed hits them alike.
inline std::vector<double> medianSeconds(const std::vector<std::function<double()>>& works, int rounds)
{
    std::vector<std::vector<double>> seconds(works.size());
    for (int round = -1; round < rounds; ++round)
    {
        for (std::size_t i = 0; i < works.size(); ++i)
        {
            const double start = cpuSeconds();
            keep(works[i]());
            if (round >= 0)
            {
                seconds[i].push_back(cpuSeconds() - start);
            }
        }
    }
    std::vector<double> medians;
    for (const std::vector<double>& ofOne : seconds)
    {
        medians.push_back(median(ofOne));
    }
    return medians;
}

/// Exponent p of y = c x^p, by least squares in the logarithms.
inline double logarithmicSlope(const std::vector<double>& x, const std::vector<double>& y)
{
    double sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        const double logX = std::log(x[i]);
        const double logY = std::log(y[i]);
        sumX += logX;
        sumY += logY;
        sumXX += logX * logX;
        sumXY += logX * logY;
    }
    const double count = static_cast<double>(x.size());
    return (count * sumXY - sumX * sumY) / (count * sumXX - sumX * sumX);
}

/// printf into a string of up to 200 characters.
template <class... Values>
std::string text(const char* format, Values... values)
{
    char buffer[200];
    std::snprintf(buffer, sizeof(buffer), format, values...);
    return buffer;
}

/// The file that tests/benchmarks/README.md describes: "# name: text" comments, then the measurements.
struct Results
{
    struct Measurement
    {
        std::string method;
        std::string knob;
        double error;
        double time;
    };
    std::vector<std::pair<std::string, std::string>> comments;
    std::vector<Measurement> measurements;

    /// Further files of the same form (and pictures): suffix "Ellipse" of subject.csv is subjectEllipse.csv.
    std::vector<Results> beside;
    std::string suffix;

    /// `path` holds the subject's name, then a dot; files beside it get their suffix in front of that.
    void write(const std::string& path) const
    {
        std::ofstream file(path);
        for (const auto& [name, comment] : comments)
        {
            file << "# " << name << ": " << comment << '\n';
        }
        file << "method,knob,error,time\n";
        for (const Measurement& row : measurements)
        {
            file << text("\"%s\",%s,%.6g,%.6g\n", row.method.c_str(), row.knob.c_str(), row.error, row.time);
        }
        if (!file.flush())
        {
            throw std::runtime_error("cannot write " + path);
        }
        for (const Results& other : beside)
        {
            const std::size_t slash = path.rfind('/');
            const std::size_t dot = path.find('.', slash == std::string::npos ? 0 : slash);
            other.write(std::string(path).insert(std::min(dot, path.size()), other.suffix));
        }
    }
};

/// The main of a benchmark: its only argument is the file to write.
inline int run(int argumentCount, char** arguments, Results (*measure)())
{
    if (argumentCount != 2)
    {
        std::fprintf(stderr, "usage: %s <file to write>\n", arguments[0]);
        return 1;
    }
    try
    {
        std::setvbuf(stdout, nullptr, _IOLBF, 0);
        measure().write(arguments[1]);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s: %s\n", arguments[0], error.what());
        return 1;
    }
    return 0;
}

} // namespace chesil::benchmark
