#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What the cases of the verification find, beside theory.
namespace chesil::dry
{

class Report
{
public:
    /// A row of the table: ok if |computed - theory| <= bound * scale; scale 0 stands for |theory|. Units: see `quantity`.
    void compare(const std::string& subject, const std::string& quantity, double computed, double theory, double bound, double scale = 0);

    /// The same, of a quantity that may be larger: the error is what it falls short of the theory, over that.
    void compareAtLeast(const std::string& subject, const std::string& quantity, double computed, double theory, double bound);

    /// A point of the picture and the theory's value at the same place.
    void plot(const std::string& panel, const std::string& xLabel, const std::string& yLabel, const std::string& series, double x, double computed, double theory);

    /// The theory of a series that has points, drawn smoothly from `low` to `high`, not by chords from point to point.
    void drawTheory(const std::string& panel, const std::string& series, double low, double high, const std::function<double(double)>& theory);

    /// Largest error of the rows whose quantity begins so, for the scoreboard (topic dryEngine, unit "-").
    void score(const std::string& name, const std::string& subject, const std::string& quantity = "") const;

    void print() const;
    /// CSV of the table and of the points. Throws std::runtime_error if a file cannot be written.
    void write(const std::string& table, const std::string& points) const;
    bool allWithin() const;

private:
    struct Row
    {
        std::string subject, quantity;
        double computed, theory, error, bound;
        bool within() const { return error <= bound; }
    };
    struct Point
    {
        std::string panel, xLabel, yLabel, series;
        double x;
        /// None: theory alone.
        std::optional<double> computed;
        double theory;
    };
    std::vector<Row> rows_;
    std::vector<Point> points_;
};

/// The cases; each adds its rows and points.
void impact(Report& report);
void obliqueImpact(Report& report);
void grazing(Report& report);
void rolling(Report& report);
void incline(Report& report);
void lattice(Report& report);
void freeMotion(Report& report);
void pile(Report& report);
void bouncing(Report& report);

} // namespace chesil::dry
