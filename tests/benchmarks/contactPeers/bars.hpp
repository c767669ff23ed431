#pragma once

#include "benchmarks/contactPeers/measurement.hpp"
#include "unit/record.hpp"

#include <stdexcept>

/// The bars of tests/bars/contactKernel.csv that this benchmark measures.
namespace chesil::benchmark
{

inline const Row& rowOf(const std::vector<Row>& rows, const std::string& shape, Situation situation,
                        const std::string& method, const std::string& knob)
{
    for (const Row& row : rows)
    {
        if (row.shape == shape && row.situation == situation && row.method == method && row.knob == knob)
        {
            return row;
        }
    }
    throw std::logic_error("contactPeers: no row " + shape + ", " + method + ", " + knob);
}

inline void hand(const std::string& name, double value, const std::string& unit, bool isBar = true)
{
    std::printf("    %-28s %10.4g %s\n", name.c_str(), value, unit == "-" ? "" : unit.c_str());
    if (isBar)
    {
        test::record("contactKernel", name, value, unit);
    }
}

inline void handSpeedups(const std::vector<Row>& rows)
{
    const auto timeOf = [&](const std::string& shape, const std::string& method, const std::string& knob)
    { return rowOf(rows, shape, Situation::shallow, method, knob).time; };
    for (const auto& [bar, shape] : {std::pair{"PolyBezier", "polybezier"}, std::pair{"Ellipse", "ellipse"}})
    {
        const double libccd = timeOf(shape, "libccd", "1e-8");
        const double warm = timeOf(shape, "Chesil", "warm");
        hand(text("warm%sSpeedup", bar), libccd / warm, "-");
        hand("  libccd on the same moves", timeOf(shape, "libccd moves", "1e-8") / warm, "-", false);
        hand("  libccd with last direction", timeOf(shape, "libccd warm", "1e-8") / warm, "-", false);
    }
    const Row& cold = rowOf(rows, "polybezier", Situation::shallow, "Chesil", "cold");
    hand("coldPolyBezierSpeedup", timeOf("polybezier", "libccd", "1e-8") / cold.time, "-");
    hand("coldPolyBezierError", cold.worstError, "-");
}

inline void handPolygons(const std::vector<Row>& rows)
{
    const auto ratio = [&](const std::vector<Situation>& situations, const std::string& knob)
    {
        double chesil = 0;
        double box2d = 0;
        for (const Situation situation : situations)
        {
            chesil += rowOf(rows, "polygon", situation, "Chesil", knob).time;
            box2d += rowOf(rows, "polygon", situation, "Box2D manifold", knob).time;
        }
        return chesil / box2d;
    };
    hand("polygonTimeOverBox2d", ratio({Situation::shallow, Situation::deep}, "cold"), "-");
    hand("  warm", ratio({Situation::shallow, Situation::deep}, "warm"), "-", false);
    hand("  cold, separate", ratio({Situation::separate}, "cold"), "-", false);
    hand("  warm, separate", ratio({Situation::separate}, "warm"), "-", false);
}

/// Each the mean over the two curved kinds. Polygons are decided by separating axes, which make no support calls and would
/// only lower the mean: theirs are printed.
inline void handCalls(const std::vector<Row>& rows)
{
    for (const std::string knob : {"cold", "warm"})
    {
        for (const Situation situation : {Situation::separate, Situation::shallow})
        {
            const std::string name = knob + (situation == Situation::separate ? "MissCalls" : "ContactCalls");
            double curved = 0;
            std::string each;
            for (const std::string shape : {"polybezier", "ellipse", "polygon"})
            {
                const double calls = rowOf(rows, shape, situation, "Chesil", knob).calls;
                curved += shape == "polygon" ? 0 : calls / 2;
                each += text("  %s %.2f", shape.c_str(), calls);
            }
            hand(name, curved, "-");
            std::printf("     %s\n", each.c_str());
        }
    }
}

} // namespace chesil::benchmark
