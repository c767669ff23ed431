/// How much accuracy of the penetration depth costs: EPA's tolerance against error and time.

#include "benchmarks/common/benchmark.hpp"
#include "benchmarks/common/overlappingPoses.hpp"
#include "benchmarks/common/referenceDepth.hpp"
#include "core/narrowphase/epa.hpp"
#include "core/narrowphase/gjk.hpp"

#include <cstdint>

using namespace chesil;
using namespace chesil::benchmark;

namespace
{

constexpr std::uint64_t seed = 20240611;
constexpr int grainCount = 60;
constexpr int pairCount = 1000;
constexpr int rounds = 51;
constexpr int firstExponent = 2;
constexpr int lastExponent = 14;

template <class ShapeType>
struct Pair
{
    const ShapeType& a;
    const ShapeType& b;
    OverlappingPoses poses;
    Real depth;

    double size() const { return a.boundingRadius() + b.boundingRadius(); }
};

template <class ShapeType>
EpaResult<2> query(const Pair<ShapeType>& pair, double tolerance)
{
    const MinkowskiDifference<2, ShapeType, ShapeType> difference(pair.a, pair.poses.a, pair.b, pair.poses.b);
    return epa<2>(difference, gjk<2>(difference, pair.poses.lookFirst).simplex, tolerance);
}

enum class Overlap
{
    shallow,
    deep
};

template <class ShapeType>
std::vector<Pair<ShapeType>> makePairs(const std::vector<ShapeType>& grains, Overlap overlap)
{
    test::RandomSource random(seed);
    const auto anyGrain = [&]() -> const ShapeType&
    { return grains[static_cast<std::size_t>(random.integer(0, static_cast<int>(grains.size()) - 1))]; };
    std::vector<Pair<ShapeType>> pairs;
    for (int i = 0; i < pairCount; ++i)
    {
        const ShapeType& a = anyGrain();
        const ShapeType& b = anyGrain();
        const OverlappingPoses poses = overlap == Overlap::shallow
                                           ? shallowPoses(a, b, random.logUniform(1e-3, 1e-1), random)
                                           : deepPoses(a, b, random);
        pairs.push_back({a, b, poses, referenceDepth(a, b, poses)});
    }
    return pairs;
}

/// CPU time [ns] of a query for each tolerance.
template <class ShapeType>
std::vector<double> measureTimes(const std::vector<Pair<ShapeType>>& pairs,
                                 const std::vector<double>& tolerances)
{
    std::vector<std::function<double()>> works;
    for (const double tolerance : tolerances)
    {
        works.push_back(
            [&pairs, tolerance]()
            {
                double sum = 0;
                for (const Pair<ShapeType>& pair : pairs)
                {
                    sum += query(pair, tolerance).depth;
                }
                return sum;
            });
    }
    std::vector<double> times = medianSeconds(works, rounds);
    for (double& time : times)
    {
        time *= 1e9 / pairCount;
    }
    return times;
}

/// Slope of the worst error over the tolerance, where rounding is far away.
void printOrder(const std::vector<double>& tolerances, const std::vector<double>& errors,
                const std::vector<double>& times)
{
    const auto last = std::find_if(errors.begin(), errors.end(), [](double error) { return error < 1e-13; });
    const auto count = last - errors.begin();
    if (count > 4)
    {
        std::printf(
            "    error ~ tolerance^%.2f, %.0f ns for a digit\n",
            logarithmicSlope({tolerances.begin(), tolerances.begin() + count}, {errors.begin(), last}),
            (times[static_cast<std::size_t>(count - 1)] - times[0]) / static_cast<double>(count - 1));
    }
}

template <class ShapeType>
void measureShape(const std::string& name, const std::vector<ShapeType>& grains, Overlap overlap,
                  const std::vector<double>& tolerances, Results& results)
{
    const std::string method = name + (overlap == Overlap::shallow ? ", shallow" : ", deep");
    const std::vector<Pair<ShapeType>> pairs = makePairs(grains, overlap);
    const std::vector<double> times = measureTimes(pairs, tolerances);
    std::vector<double> worstErrors;
    for (std::size_t k = 0; k < tolerances.size(); ++k)
    {
        std::vector<double> errors;
        int unconverged = 0;
        for (const Pair<ShapeType>& pair : pairs)
        {
            const EpaResult<2> result = query(pair, tolerances[k]);
            errors.push_back(static_cast<double>(std::abs(result.depth - pair.depth)) / pair.size());
            unconverged += result.status != EpaStatus::converged;
        }
        worstErrors.push_back(*std::max_element(errors.begin(), errors.end()));
        const std::string knob = text("1e-%d", firstExponent + static_cast<int>(k));
        results.measurements.push_back({method, knob, worstErrors.back(), times[k]});
        std::printf("    %-19s  %-5s  %8.1e  %8.1e  %6.0f  %11d\n", method.c_str(), knob.c_str(),
                    median(errors), worstErrors.back(), times[k], unconverged);
    }
    printOrder(tolerances, worstErrors, times);
}

Results measure()
{
    std::printf("    seed %llu, %d grains and %d pairs of each kind\n", static_cast<unsigned long long>(seed),
                grainCount, pairCount);
    std::printf("    %-19s  %-5s  %8s  %8s  %6s  %11s\n", "pairs", "toler.", "median", "worst", "ns",
                "unconverged");

    Results results;
    results.comments = {
        {"title", "EPA tolerance: penetration depth of random pairs"},
        {"error", "largest error of the depth over the pair's size [-]"},
        {"time", "time of a query, GJK and EPA [ns]"},
        {"knob", "EPA's relative tolerance"},
        {"size", "sum of the two bounding radii; shallow: depth 1e-3..1e-1 of it, deep: centroids 0.05..0.5 "
                 "of it apart"},
        {"reference", "minimum over all directions, in long double, without GJK and EPA"},
        {"clock", text("CPU time, median of %d rounds over %d pairs", rounds, pairCount)},
        {"seed", std::to_string(seed)},
    };
    std::vector<double> tolerances;
    for (int exponent = firstExponent; exponent <= lastExponent; ++exponent)
    {
        tolerances.push_back(std::pow(10.0, -exponent));
    }

    test::RandomSource random(seed);
    std::vector<PolyBezier> grains;
    std::vector<Ellipse> ellipses;
    std::vector<ConvexPolygon> polygons;
    for (int i = 0; i < grainCount; ++i)
    {
        grains.push_back(test::randomPolyBezier(test::RandomGrainOptions(), random));
        ellipses.emplace_back(1, random.uniform(0.3, 1));
        polygons.push_back(test::randomPolygon(10, 1, random));
    }
    for (const Overlap overlap : {Overlap::shallow, Overlap::deep})
    {
        measureShape("polybezier", grains, overlap, tolerances, results);
        measureShape("ellipse", ellipses, overlap, tolerances, results);
        measureShape("polygon", polygons, overlap, tolerances, results);
    }
    return results;
}

} // namespace

int main(int argumentCount, char** arguments) { return run(argumentCount, arguments, measure); }
