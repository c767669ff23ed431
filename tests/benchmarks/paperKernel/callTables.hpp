#pragma once

#include "benchmarks/paperKernel/supportCalls.hpp"
#include "benchmarks/paperKernel/table.hpp"

#include <array>
#include <map>
#include <set>

namespace chesil::benchmark
{

using CallCount = int PairCalls::*;

/// One of the ways in which the calls of a query are counted.
struct Counter
{
    const char* name;
    CallCount calls;
    /// Averages that the paper prints, 0 where it has none.
    double paperSeparate;
    double paperContact;
};

inline const std::array<Counter, 4> counters{{{"GJK", &PairCalls::gjk, 1.85, 5.77},
                                              {"GJK and EPA to 1e-12", &PairCalls::gjkAndEpa, 0, 0},
                                              {"engine cold", &PairCalls::engineCold, 0, 0},
                                              {"engine warm", &PairCalls::engineWarm, 0, 0}}};

/// Fig. 14: how many pairs take how many calls.
inline void writeHistograms(const std::string& path, const std::vector<PairCalls>& all)
{
    Table table(path, "counter,contact,paperMean,calls,pairs");
    std::printf("    support calls of A - B a query      separate  (paper)   contact  (paper)\n");
    for (const Counter& counter : counters)
    {
        double means[2];
        for (const bool inContact : {false, true})
        {
            std::vector<int> calls;
            std::map<int, int> pairs;
            for (const PairCalls& pair : all)
            {
                if (pair.inContact == inContact)
                {
                    calls.push_back(pair.*counter.calls);
                    ++pairs[calls.back()];
                }
            }
            means[inContact] = mean(calls);
            for (const auto& [count, number] : pairs)
            {
                table.row("%s,%d,%g,%d,%d", counter.name, static_cast<int>(inContact),
                          inContact ? counter.paperContact : counter.paperSeparate, count, number);
            }
        }
        const auto ofPaper = [](double value) { return value > 0 ? text("%.2f", value) : std::string("-"); };
        std::printf("      %-30s  %10.2f  %7s  %8.2f  %7s\n", counter.name, means[0],
                    ofPaper(counter.paperSeparate).c_str(), means[1], ofPaper(counter.paperContact).c_str());
    }
    const auto count = [&](auto flag) { return std::count_if(all.begin(), all.end(), flag); };
    std::printf("      engine's sweeps over all directions: %td cold, %td warm\n",
                count([](const PairCalls& pair) { return pair.coldFellBack; }),
                count([](const PairCalls& pair) { return pair.warmFellBack; }));
    double largest = 0;
    for (const PairCalls& pair : all)
    {
        largest = std::max(largest, pair.depthDifference);
    }
    std::printf("      engine's depth less EPA's over the pair's size: %.1e at most\n", largest);
    table.close();
}

struct PairType
{
    const char* first;
    const char* second;
    double paper;
};

constexpr std::array<PairType, 6> pairTypes{{{"ellipse", "ellipse", 5.33},
                                             {"ellipse", "polygon", 4.48},
                                             {"ellipse", "polybezier", 5.72},
                                             {"polygon", "polygon", 2.64},
                                             {"polygon", "polybezier", 3.96},
                                             {"polybezier", "polybezier", 4.99}}};

inline std::multiset<std::string> typeOf(const NearPair& pair)
{
    const auto name = [](const auto& shape) { return std::string(shape.typeName); };
    return {std::visit(name, *pair.a), std::visit(name, *pair.b)};
}

/// Table 1: mean calls of each pair type.
inline void writePairTypes(const std::string& path, const std::vector<NearPair>& pairs,
                           const std::vector<PairCalls>& all)
{
    Table table(path, "first,second,paper,counter,contact,separate,both,contactPairs,separatePairs");
    std::printf("    Table 1, GJK's calls (paper: contact and separate together)\n");
    std::printf("      %-24s  %7s  %7s  %8s  %7s  %13s\n", "pair", "paper", "contact", "separate", "both",
                "pairs");
    for (const PairType& type : pairTypes)
    {
        for (const Counter& counter : counters)
        {
            std::vector<int> contact, separate, both;
            for (std::size_t i = 0; i < pairs.size(); ++i)
            {
                if (typeOf(pairs[i]) == std::multiset<std::string>{type.first, type.second})
                {
                    both.push_back(all[i].*counter.calls);
                    (all[i].inContact ? contact : separate).push_back(both.back());
                }
            }
            table.row("%s,%s,%g,%s,%.4f,%.4f,%.4f,%zu,%zu", type.first, type.second, type.paper, counter.name,
                      mean(contact), mean(separate), mean(both), contact.size(), separate.size());
            if (counter.calls == &PairCalls::gjk)
            {
                std::printf("      %-24s  %7.2f  %7.2f  %8.2f  %7.2f  %6zu %6zu\n",
                            text("%s, %s", type.first, type.second).c_str(), type.paper, mean(contact),
                            mean(separate), mean(both), contact.size(), separate.size());
            }
        }
    }
    table.close();
}

} // namespace chesil::benchmark
