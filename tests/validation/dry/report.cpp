#include "validation/dry/report.hpp"

#include "unit/record.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace chesil::dry
{

void Report::compare(const std::string& subject, const std::string& quantity, double computed, double theory, double bound, double scale)
{
    const double error = std::abs(computed - theory) / (scale > 0 ? scale : std::abs(theory));
    rows_.push_back({subject, quantity, computed, theory, error, bound});
}

void Report::compareAtLeast(const std::string& subject, const std::string& quantity, double computed, double theory, double bound)
{
    const double error = computed >= theory ? 0 : (theory - computed) / theory;
    rows_.push_back({subject, quantity, computed, theory, error, bound});
}

void Report::plot(const std::string& panel, const std::string& xLabel, const std::string& yLabel, const std::string& series, double x, double computed, double theory)
{
    points_.push_back({panel, xLabel, yLabel, series, x, computed, theory});
}

void Report::drawTheory(const std::string& panel, const std::string& series, double low, double high, const std::function<double(double)>& theory)
{
    const auto ofPanel = [&](const Point& point) { return point.panel == panel && point.series == series; };
    const auto found = std::find_if(points_.begin(), points_.end(), ofPanel);
    if (found == points_.end())
    {
        throw std::logic_error("no points of " + panel + ", " + series);
    }
    const Point sample = *found;
    constexpr int pieces = 200;
    for (int i = 0; i <= pieces; ++i)
    {
        const double x = low + (high - low) * i / pieces;
        points_.push_back({panel, sample.xLabel, sample.yLabel, series, x, std::nullopt, theory(x)});
    }
}

void Report::score(const std::string& name, const std::string& subject, const std::string& quantity) const
{
    double worst = -1;
    for (const Row& row : rows_)
    {
        if (row.subject == subject && row.quantity.compare(0, quantity.size(), quantity) == 0)
        {
            // max() would drop an error that is no number.
            worst = row.error <= worst ? worst : row.error;
        }
    }
    if (worst == -1)
    {
        throw std::logic_error("no row for the figure " + name);
    }
    test::record("dryEngine", name, worst, "-");
}

void Report::print() const
{
    std::printf("%-10s %-54s %14s %14s %10s %10s\n", "case", "quantity", "computed", "theory", "error", "bound");
    for (const Row& row : rows_)
    {
        std::printf("%-10s %-54s %14.8g %14.8g %10.2e %10.2e %s\n", row.subject.c_str(), row.quantity.c_str(), row.computed, row.theory, row.error, row.bound, row.within() ? "ok" : "MISSED");
    }
}

void Report::write(const std::string& table, const std::string& points) const
{
    std::ofstream out(table);
    out.precision(10);
    out << "case,quantity,computed,theory,error,bound,ok\n";
    for (const Row& row : rows_)
    {
        out << row.subject << ',' << row.quantity << ',' << row.computed << ',' << row.theory << ',' << row.error << ',' << row.bound << ',' << row.within() << '\n';
    }
    std::ofstream drawn(points);
    drawn.precision(10);
    drawn << "panel,xLabel,yLabel,series,x,computed,theory\n";
    for (const Point& point : points_)
    {
        drawn << point.panel << ',' << point.xLabel << ',' << point.yLabel << ',' << point.series << ',' << point.x << ',';
        if (point.computed)
        {
            drawn << *point.computed;
        }
        drawn << ',' << point.theory << '\n';
    }
    out.close();
    drawn.close();
    if (!out || !drawn)
    {
        throw std::runtime_error("cannot write " + table + " or " + points);
    }
}

bool Report::allWithin() const
{
    return std::all_of(rows_.begin(), rows_.end(), [](const Row& row) { return row.within(); });
}

} // namespace chesil::dry
