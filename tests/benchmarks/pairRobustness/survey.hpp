#pragma once

#include "benchmarks/pairRobustness/judge.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <map>
#include <tuple>

namespace chesil::benchmark
{

/// A query that is worth a look.
struct Remarkable
{
    std::int64_t index = -1;
    Stratum stratum;
    bool warm = false;
    double share = 0;
};

/// Sums and worst values over a class of pairs, two queries each.
struct Tally
{
    std::int64_t pairs = 0;
    std::int64_t failures = 0;
    std::int64_t wrongVerdicts = 0;
    std::int64_t flawed = 0;
    std::int64_t misdirected = 0;
    std::int64_t inexact = 0;
    std::int64_t unsettled = 0;
    std::int64_t contacts = 0;
    std::int64_t supports = 0;
    /// Depth's error over the larger bounding radius.
    double worstError = 0;
    /// Depth's error and the normal's over roundingBound.
    double worstShare = 0;
    double worstNormalShare = 0;
    /// Thread time of all cold and warm queries [s].
    double coldSeconds = 0;
    double warmSeconds = 0;
    /// The query of worstShare.
    Remarkable worst;

    void add(const Judgement& judgement, const RandomPair& pair, const Remarkable& query)
    {
        failures += judgement.failure;
        wrongVerdicts += judgement.wrongVerdict;
        flawed += judgement.flawed;
        misdirected += judgement.misdirected;
        inexact += judgement.inexact;
        unsettled += judgement.unsettled;
        contacts += judgement.depth > 0;
        supports += judgement.supports;
        worstError = std::max(worstError, judgement.error / pair.larger());
        worstNormalShare = std::max(worstNormalShare, judgement.normalError / roundingBound(pair));
        const double share = judgement.error / roundingBound(pair);
        if (share > worstShare)
        {
            worst = query;
            worst.share = share;
            worstShare = share;
        }
    }

    void add(const Tally& other)
    {
        pairs += other.pairs;
        failures += other.failures;
        wrongVerdicts += other.wrongVerdicts;
        flawed += other.flawed;
        misdirected += other.misdirected;
        inexact += other.inexact;
        unsettled += other.unsettled;
        contacts += other.contacts;
        supports += other.supports;
        worstError = std::max(worstError, other.worstError);
        worstNormalShare = std::max(worstNormalShare, other.worstNormalShare);
        coldSeconds += other.coldSeconds;
        warmSeconds += other.warmSeconds;
        if (other.worstShare > worstShare ||
            (other.worstShare == worstShare && other.worst.index < worst.index))
        {
            worst = other.worst;
            worstShare = other.worstShare;
        }
    }

    double coldNanoseconds() const
    {
        return 1e9 * coldSeconds / static_cast<double>(std::max<std::int64_t>(pairs, 1));
    }
    double warmNanoseconds() const
    {
        return 1e9 * warmSeconds / static_cast<double>(std::max<std::int64_t>(pairs, 1));
    }
};

/// CPU time of this thread [s].
inline double threadSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Batches of pairs of one stratum: made, asked cold, moved, asked warm with what came back, judged. Surveys
/// of other batches can be added up.
class Survey
{
public:
    using Key = std::tuple<bool, int, int, int>;

    Survey(const PairMaker& maker, int batchSize) : maker_(maker), batchSize_(batchSize) {}

    void runBatch(std::int64_t batch)
    {
        const Stratum stratum = stratumOf(batch);
        Tally& tally =
            tallies_[{stratum.wellScaled, static_cast<int>(stratum.situation), stratum.typeA, stratum.typeB}];
        const std::int64_t first = batch * batchSize_;
        std::vector<RandomPair> pairs;
        for (int i = 0; i < batchSize_; ++i)
        {
            pairs.push_back(maker_.make(stratum, first + i));
        }
        std::vector<Answer> answers(pairs.size());
        tally.pairs += batchSize_;
        tally.coldSeconds += askAll(pairs, false, answers);
        judgeAll(pairs, false, answers, {first, stratum, false, 0}, tally);
        tally.warmSeconds += askAll(pairs, true, answers);
        judgeAll(pairs, true, answers, {first, stratum, true, 0}, tally);
    }

    void add(const Survey& other)
    {
        for (const auto& [key, tally] : other.tallies_)
        {
            tallies_[key].add(tally);
        }
        for (std::size_t flaw = 0; flaw < flaws; ++flaw)
        {
            std::vector<Remarkable>& all = remarkable_[flaw];
            all.insert(all.end(), other.remarkable_[flaw].begin(), other.remarkable_[flaw].end());
            std::sort(all.begin(), all.end(),
                      [](const Remarkable& a, const Remarkable& b)
                      { return std::tie(a.index, a.warm) < std::tie(b.index, b.warm); });
            all.resize(std::min(all.size(), mostRemarkable));
        }
    }

    /// The sum over all classes that the filter takes.
    template <class Filter>
    Tally sum(const Filter& filter) const
    {
        Tally result;
        for (const auto& [key, tally] : tallies_)
        {
            const auto& [well, situation, typeA, typeB] = key;
            if (filter(Stratum{static_cast<Situation>(situation), typeA, typeB, well}))
            {
                result.add(tally);
            }
        }
        return result;
    }

    /// The first queries with a flaw.
    const std::vector<Remarkable>& remarkable(Flaw flaw) const
    {
        return remarkable_[static_cast<std::size_t>(flaw)];
    }

private:
    static constexpr std::size_t mostRemarkable = 20;

    static double askAll(const std::vector<RandomPair>& pairs, bool warm, std::vector<Answer>& answers)
    {
        const double start = threadSeconds();
        for (std::size_t i = 0; i < pairs.size(); ++i)
        {
            ask(pairs[i], warm ? pairs[i].laterB : pairs[i].poseB, answers[i]);
        }
        return threadSeconds() - start;
    }

    void judgeAll(const std::vector<RandomPair>& pairs, bool warm, const std::vector<Answer>& answers,
                  Remarkable query, Tally& tally)
    {
        for (std::size_t i = 0; i < pairs.size(); ++i, ++query.index)
        {
            const Judgement judgement = judge(pairs[i], warm ? pairs[i].laterB : pairs[i].poseB, answers[i]);
            tally.add(judgement, pairs[i], query);
            for (int flaw = 0; flaw < flaws; ++flaw)
            {
                std::vector<Remarkable>& all = remarkable_[static_cast<std::size_t>(flaw)];
                if (judgement.has(static_cast<Flaw>(flaw)) && all.size() < mostRemarkable)
                {
                    all.push_back(query);
                }
            }
        }
    }

    const PairMaker& maker_;
    int batchSize_;
    std::map<Key, Tally> tallies_;
    std::array<std::vector<Remarkable>, flaws> remarkable_;
};

} // namespace chesil::benchmark
