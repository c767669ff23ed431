#pragma once

#include "benchmarks/common/benchmark.hpp"

namespace chesil::benchmark
{

/// A file beside the benchmark's result, row by row.
class Table
{
public:
    Table(const std::string& path, const std::string& header) : path_(path), file_(path)
    {
        file_ << header << '\n';
    }

    template <class... Values>
    void row(const char* format, Values... values)
    {
        file_ << text(format, values...) << '\n';
    }

    void close()
    {
        if (!file_.flush())
        {
            throw std::runtime_error("cannot write " + path_);
        }
    }

private:
    std::string path_;
    std::ofstream file_;
};

inline double mean(const std::vector<int>& values)
{
    double sum = 0;
    for (const int value : values)
    {
        sum += value;
    }
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

} // namespace chesil::benchmark
