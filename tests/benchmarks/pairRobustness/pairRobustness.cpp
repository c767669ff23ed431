/// Random pairs of all shapes, sizes, aspects, places and scales: does the pair contact fail, err on contact
/// or none, or on the depth? Each pair is asked cold and, moved a little, warm; the reference is
/// unit/preciseDepth.hpp.
///
/// CHESIL_PAIRS=100000 for a short trial; CHESIL_PAIR=1234 prints all of one pair instead; CHESIL_SEED for
/// other pairs; CHESIL_THREADS.

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/pairRobustness/printPair.hpp"
#include "benchmarks/pairRobustness/survey.hpp"
#include "unit/record.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <thread>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr int batchSize = 100;
constexpr int scaleGroups = 32;
constexpr std::int64_t allPairs = 10000000;

std::int64_t numberFrom(const char* variable, std::int64_t otherwise)
{
    const char* given = std::getenv(variable);
    return given ? std::atoll(given) : otherwise;
}

/// Another one is a trial on pairs that no one has seen yet.
const auto seed = static_cast<std::uint64_t>(numberFrom("CHESIL_SEED", 20250307));

/// A line now and then: done, time left.
class Progress
{
public:
    explicit Progress(std::int64_t batches) : batches_(batches) {}

    void tell(std::int64_t done)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
        if (seconds > lastTold_ + 30)
        {
            lastTold_ = seconds;
            const double share = static_cast<double>(done) / static_cast<double>(batches_);
            std::printf("    %5.1f %% after %.0f s, %.0f s left\n", 100 * share, seconds,
                        seconds * (1 - share) / share);
        }
    }

private:
    using Clock = std::chrono::steady_clock;
    std::int64_t batches_;
    Clock::time_point start_ = Clock::now();
    double lastTold_ = 0;
    std::mutex mutex_;
};

Survey surveyAll(const PairMaker& maker, std::int64_t batches)
{
    std::atomic<std::int64_t> next{0};
    Progress progress(batches);
    const auto threads = static_cast<std::size_t>(
        numberFrom("CHESIL_THREADS", std::max(1u, std::thread::hardware_concurrency())));
    std::vector<Survey> parts(threads, Survey(maker, batchSize));
    std::vector<std::thread> workers;
    for (Survey& part : parts)
    {
        workers.emplace_back(
            [&]
            {
                for (std::int64_t batch = next++; batch < batches; batch = next++)
                {
                    part.runBatch(batch);
                    progress.tell(batch + 1);
                }
            });
    }
    for (std::thread& worker : workers)
    {
        worker.join();
    }
    Survey whole(maker, batchSize);
    for (const Survey& part : parts)
    {
        whole.add(part);
    }
    return whole;
}

void printHeader(const char* what)
{
    std::printf("\n    %-22s %9s %9s %8s %6s %6s %6s %6s %7s %9s %9s %9s %6s %6s %5s\n", what, "pairs",
                "contacts", "failures", "wrong", "flawed", "misdir", "unsett", "inexact", "error", "of bound",
                "normal", "cold", "warm", "calls");
}

void printRow(const std::string& name, const Tally& tally)
{
    if (tally.pairs > 0)
    {
        std::printf(
            "    %-22s %9lld %9lld %8lld %6lld %6lld %6lld %6lld %7lld %9.2g %9.2g %9.2g %6.0f %6.0f %5.0f\n",
            name.c_str(), static_cast<long long>(tally.pairs), static_cast<long long>(tally.contacts),
            static_cast<long long>(tally.failures), static_cast<long long>(tally.wrongVerdicts),
            static_cast<long long>(tally.flawed), static_cast<long long>(tally.misdirected),
            static_cast<long long>(tally.unsettled), static_cast<long long>(tally.inexact), tally.worstError,
            tally.worstShare, tally.worstNormalShare, tally.coldNanoseconds(), tally.warmNanoseconds(),
            static_cast<double>(tally.supports) / static_cast<double>(2 * tally.pairs));
    }
}

template <class Action>
void forTypePairs(const Action& action)
{
    for (int a = 0; a < shapeTypes; ++a)
    {
        for (int b = a; b < shapeTypes; ++b)
        {
            action(a, b);
        }
    }
}

void printTables(const Survey& survey)
{
    std::printf(
        "\n    failures, wrong, flawed (normal or point no good), misdirected (direction does not separate), "
        "unsettled (reference), inexact (beyond the bound): of two queries a pair\n"
        "    error: of the depth, over the larger bounding radius; of bound, normal: depth's and normal's "
        "over "
        "16 epsilon (R_A + R_B)\n    cold, warm: ns a query; calls: of the reference\n");
    for (const bool well : {true, false})
    {
        printHeader(well ? "well-scaled" : "wide");
        for (int s = 0; s < situations; ++s)
        {
            printRow(situationName(s),
                     survey.sum(
                         [&](const Stratum& stratum)
                         { return stratum.wellScaled == well && static_cast<int>(stratum.situation) == s; }));
        }
        forTypePairs(
            [&](int a, int b)
            {
                printRow(Stratum{Situation::separate, a, b, well}.types(),
                         survey.sum(
                             [&](const Stratum& stratum) {
                                 return stratum.wellScaled == well && stratum.typeA == a &&
                                        stratum.typeB == b;
                             }));
            });
        printRow("all", survey.sum([&](const Stratum& stratum) { return stratum.wellScaled == well; }));
    }
}

void printRemarkable(const Survey& survey, const PairMaker& maker)
{
    const auto show = [&](const Remarkable& query)
    { print(query.stratum, query.index, maker.make(query.stratum, query.index), false); };
    std::printf("\n    Largest shares of the bound; CHESIL_PAIR=<pair> prints the shapes, too\n");
    for (const bool well : {true, false})
    {
        const Tally tally = survey.sum([&](const Stratum& stratum) { return stratum.wellScaled == well; });
        if (tally.worst.index >= 0)
        {
            show(tally.worst);
        }
    }
    static const char* const names[flaws] = {"status is a failure", "verdict is wrong", "contact is flawed",
                                             "direction does not separate",
                                             "depth is off by more than the bound"};
    for (int flaw = 0; flaw < flaws; ++flaw)
    {
        std::printf("\n    The first pairs whose %s\n", names[flaw]);
        std::int64_t last = -1;
        for (const Remarkable& query : survey.remarkable(static_cast<Flaw>(flaw)))
        {
            if (query.index != last)
            {
                show(query);
            }
            last = query.index;
        }
    }
}

void recordBars(const Survey& survey, std::int64_t pairs)
{
    const Tally all = survey.sum([](const Stratum&) { return true; });
    const Tally well = survey.sum([](const Stratum& stratum) { return stratum.wellScaled; });
    const Tally wide = survey.sum([](const Stratum& stratum) { return !stratum.wellScaled; });
    const auto note = [](const char* name, double value, const char* unit)
    {
        std::printf("    %-20s %.6g %s\n", name, value, unit);
        test::record("contactKernel", name, value, unit);
    };
    std::printf("\n");
    note("robustPairs", static_cast<double>(pairs), "pairs");
    note("robustFailures", static_cast<double>(all.failures + all.flawed), "-");
    note("robustWrongVerdicts", static_cast<double>(all.wrongVerdicts), "-");
    note("robustDepthError", well.worstError, "-");
    note("robustBoundShare", wide.worstShare, "-");
}

Results resultsOf(const Survey& survey, std::int64_t pairs)
{
    Results results;
    results.comments = {
        {"title", "Random pairs: depth against a reference in long double"},
        {"error", "largest error of the depth over the larger bounding radius [-]"},
        {"time", "time of a query, mean of cold and warm [ns]"},
        {"knob", "types of the two shapes"},
        {"drawing", "points"},
        {"pairs", text("%lld, half of them well-scaled", static_cast<long long>(pairs))},
        {"reference", "least height over all directions in long double, within 1e-17 of the sizes"},
        {"seed", std::to_string(seed)},
    };
    for (int s = 0; s < situations; ++s)
    {
        forTypePairs(
            [&](int a, int b)
            {
                const Tally tally = survey.sum(
                    [&](const Stratum& stratum) {
                        return static_cast<int>(stratum.situation) == s && stratum.typeA == a &&
                               stratum.typeB == b;
                    });
                if (tally.pairs > 0)
                {
                    results.measurements.push_back(
                        {situationName(s), Stratum{Situation::separate, a, b, true}.types(), tally.worstError,
                         (tally.coldNanoseconds() + tally.warmNanoseconds()) / 2});
                }
            });
    }
    return results;
}

Results measure()
{
    const GrainPool pool(seed, scaleGroups);
    const PairMaker maker(pool, seed);
    const std::int64_t one = numberFrom("CHESIL_PAIR", -1);
    if (one >= 0)
    {
        const Stratum stratum = stratumOf(one / batchSize);
        print(stratum, one, maker.make(stratum, one), true);
        return Results();
    }
    const std::int64_t batches = (numberFrom("CHESIL_PAIRS", allPairs) + batchSize - 1) / batchSize;
    const std::int64_t pairs = batches * batchSize;
    std::printf("    seed %llu, %zu grains (%d more refused), %lld pairs\n",
                static_cast<unsigned long long>(seed), pool.size(), pool.refused(),
                static_cast<long long>(pairs));
    const Survey survey = surveyAll(maker, batches);
    printTables(survey);
    printRemarkable(survey, maker);
    recordBars(survey, pairs);
    return resultsOf(survey, pairs);
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
