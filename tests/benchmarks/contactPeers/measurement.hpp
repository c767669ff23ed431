#pragma once

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/contactPeers/pairSets.hpp"
#include "core/narrowphase/searchStart.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <numeric>

/// A method ("peer") is asked about pair i after s moves by
///
///     template <bool judged> Answer query(std::size_t s, std::size_t i, SearchStart& start, int& calls)
///     const
///
/// `start` is empty or what the last query of this pair left there. The timed queries are not `judged`:
/// only the others have to count support calls of A - B and to work out a depth that the peer does not give
/// by itself.
namespace chesil::benchmark
{

/// What a method says about a pair.
struct Answer
{
    bool overlap;
    /// Penetration depth [m], if they overlap.
    double depth;
};

/// A row of the table.
struct Row
{
    std::string shape;
    Situation situation;
    std::string method;
    std::string knob;
    /// Of a query, CPU time [ns].
    double time = 0;
    /// Errors of the depth over the pair's size, contacts with the right verdict only.
    double medianError = 0;
    double worstError = 0;
    /// Queries with a wrong verdict (contact or none), and contacts with an error above farOff.
    int wrong = 0;
    int far = 0;
    /// Mean support calls of A - B; negative if the method knows none.
    double calls = 0;
};

/// Hands no direction from one query to the next.
template <class Peer>
class ForgetDirection
{
public:
    explicit ForgetDirection(std::shared_ptr<Peer> peer) : peer_(std::move(peer)) {}

    template <bool judged>
    Answer query(std::size_t step, std::size_t i, SearchStart&, int& calls) const
    {
        SearchStart none;
        return peer_->template query<judged>(step, i, none, calls);
    }

private:
    std::shared_ptr<Peer> peer_;
};

constexpr double farOff = 1e-3;

enum class Start
{
    cold, ///< the pairs before their first move, each without a start
    warm, ///< the moves, each with the start that the last query left
};

/// All methods on one set of pairs.
template <class ShapeType>
class Contest
{
public:
    Contest(std::string shape, const PairSet<ShapeType>& set) : shape_(std::move(shape)), set_(set) {}

    template <class Peer>
    void add(const std::string& method, const std::string& knob, const std::shared_ptr<Peer>& peer,
             Start start)
    {
        Row row{shape_, set_.situation, method, knob};
        if (start == Start::cold)
        {
            judgeCold(*peer, row);
            works_.push_back([peer, this]() { return runCold(*peer); });
            queries_.push_back(set_.pairs.size());
        }
        else
        {
            judgeWarm(*peer, row);
            works_.push_back([peer, this, first = firstStarts(*peer)]()
                             { return runWarm(*peer, first); });
            queries_.push_back(set_.pairs.size() * steps);
        }
        rows_.push_back(row);
    }

    /// Times all methods and returns the table. In turn come methods far from each other in the table: after
    /// one of its own kind, a short one would find caches and branches that have learned these very pairs.
    std::vector<Row> run(int rounds)
    {
        const std::size_t count = rows_.size();
        std::size_t stride = count * 2 / 5 + 1;
        while (std::gcd(stride, count) != 1)
        {
            ++stride;
        }
        std::vector<std::function<double()>> works;
        for (std::size_t place = 0; place < count; ++place)
        {
            works.push_back(works_[place * stride % count]);
        }
        const std::vector<double> seconds = medianSeconds(works, rounds);
        for (std::size_t place = 0; place < count; ++place)
        {
            const std::size_t k = place * stride % count;
            rows_[k].time = 1e9 * seconds[place] / static_cast<double>(queries_[k]);
        }
        return rows_;
    }

private:
    template <class Peer>
    double runCold(const Peer& peer) const
    {
        double sum = 0;
        int calls = 0;
        for (std::size_t i = 0; i < set_.pairs.size(); ++i)
        {
            SearchStart start;
            sum += peer.template query<false>(0, i, start, calls).depth;
        }
        return sum;
    }

    /// As a time loop does: all pairs, then the next move.
    template <class Peer>
    double runWarm(const Peer& peer, std::vector<SearchStart> starts) const
    {
        double sum = 0;
        int calls = 0;
        for (std::size_t step = 1; step <= steps; ++step)
        {
            for (std::size_t i = 0; i < set_.pairs.size(); ++i)
            {
                sum += peer.template query<false>(step, i, starts[i], calls).depth;
            }
        }
        return sum;
    }

    template <class Peer>
    std::vector<SearchStart> firstStarts(const Peer& peer) const
    {
        std::vector<SearchStart> starts(set_.pairs.size());
        int calls = 0;
        for (std::size_t i = 0; i < set_.pairs.size(); ++i)
        {
            peer.template query<true>(0, i, starts[i], calls);
        }
        return starts;
    }

    template <class Peer>
    void judgeCold(const Peer& peer, Row& row) const
    {
        int calls = 0;
        std::vector<double> errors;
        for (std::size_t i = 0; i < set_.pairs.size(); ++i)
        {
            SearchStart start;
            note(peer.template query<true>(0, i, start, calls), set_.before[i], errors, row);
        }
        summarize(errors, static_cast<double>(calls) / static_cast<double>(set_.pairs.size()), row);
    }

    /// Errors after the last move; verdicts and calls of all.
    template <class Peer>
    void judgeWarm(const Peer& peer, Row& row) const
    {
        std::vector<SearchStart> starts = firstStarts(peer);
        int calls = 0;
        std::vector<double> errors;
        for (std::size_t step = 1; step <= steps; ++step)
        {
            for (std::size_t i = 0; i < set_.pairs.size(); ++i)
            {
                const Answer answer = peer.template query<true>(step, i, starts[i], calls);
                if (step == steps)
                {
                    note(answer, set_.after[i], errors, row);
                }
                else
                {
                    row.wrong += answer.overlap != (set_.situation != Situation::separate);
                }
            }
        }
        summarize(errors, static_cast<double>(calls) / static_cast<double>(steps * set_.pairs.size()), row);
    }

    static void note(const Answer& answer, const Truth& truth, std::vector<double>& errors, Row& row)
    {
        const bool overlap = truth.depth > 0;
        row.wrong += answer.overlap != overlap;
        if (answer.overlap && overlap)
        {
            errors.push_back(static_cast<double>(std::abs(answer.depth - truth.depth)) / truth.size);
            row.far += !(errors.back() <= farOff);
        }
    }

    static void summarize(const std::vector<double>& errors, double calls, Row& row)
    {
        row.calls = calls;
        if (!errors.empty())
        {
            row.medianError = median(errors);
            row.worstError = *std::max_element(errors.begin(), errors.end());
        }
    }

    std::string shape_;
    const PairSet<ShapeType>& set_;
    std::vector<std::function<double()>> works_;
    std::vector<std::size_t> queries_;
    std::vector<Row> rows_;
};

inline void printHeader()
{
    std::printf("    %-10s  %-8s  %-20s  %-8s  %7s  %7s  %7s  %5s  %5s  %6s\n", "pairs", "", "method", "knob",
                "ns", "median", "worst", "wrong", "far", "calls");
}

inline void print(const Row& row)
{
    const bool contact = row.situation != Situation::separate;
    const std::string errors =
        contact ? text("%7.1e  %7.1e", row.medianError, row.worstError) : text("%7s  %7s", "-", "-");
    std::printf("    %-10s  %-8s  %-20s  %-8s  %7.0f  %s  %5d  %5d  %6s\n", row.shape.c_str(),
                nameOf(row.situation), row.method.c_str(), row.knob.c_str(), row.time, errors.c_str(),
                row.wrong, row.far, row.calls >= 0 ? text("%.2f", row.calls).c_str() : "-");
}

} // namespace chesil::benchmark
