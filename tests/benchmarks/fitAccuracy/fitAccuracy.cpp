/// How well polybezier grains of ever more segments, found by the direct solver or by the paper's particle
/// swarm, and polygons render the shapes of the chart of sphericity and roundness, and what finding them
/// costs.

#include "benchmarks/common/benchmark.hpp"
#include "generate/fit/grainFit.hpp"
#include "unit/generate/chartShapes.hpp"
#include "unit/record.hpp"

namespace chesil::benchmark
{

namespace
{

/// Segments at which the methods are compared, those of the paper's Fig. 7.
constexpr int comparedSegments = 10;

struct Sample
{
    double medianError;
    double worstError;
    double milliseconds;
};

std::vector<Silhouette> chartShapes()
{
    std::vector<Silhouette> shapes;
    for (const double sphericity : test::chartSphericities())
    {
        for (const double roundness : test::chartRoundnesses())
        {
            shapes.push_back(test::drawnChartShape(sphericity, roundness));
        }
    }
    return shapes;
}

/// Times are medians over the shapes of the medians of three rounds.
Sample sampled(const std::vector<Silhouette>& shapes, const FitSettings& settings)
{
    std::vector<double> errors;
    std::vector<double> times;
    for (const Silhouette& shape : shapes)
    {
        std::vector<double> rounds;
        for (int round = 0; round < 3; ++round)
        {
            const GrainFit fit = fitGrain(shape, settings);
            rounds.push_back(fit.milliseconds);
            if (round == 0)
            {
                errors.push_back(1 - fit.accuracySilhouette);
            }
        }
        times.push_back(median(rounds));
    }
    return {median(errors), *std::max_element(errors.begin(), errors.end()), median(times)};
}

class Sweep
{
public:
    Sample add(const std::string& method, const std::string& knob, const FitSettings& settings)
    {
        const Sample sample = sampled(shapes_, settings);
        std::printf("%-28s %10s  median %.5f  worst %.5f  %8.2f ms\n", method.c_str(), knob.c_str(),
                    sample.medianError, sample.worstError, sample.milliseconds);
        medians_.measurements.push_back({method, knob, sample.medianError, sample.milliseconds / 1000});
        worst_.measurements.push_back({method, knob, sample.worstError, sample.milliseconds / 1000});
        return sample;
    }

    Results results() const
    {
        Results all = medians_;
        all.comments = comments("median");
        Results worst = worst_;
        worst.comments = comments("largest");
        worst.suffix = "Worst";
        all.beside.push_back(worst);
        return all;
    }

private:
    static std::vector<std::pair<std::string, std::string>> comments(const std::string& which)
    {
        return {{"title", "Fit of 20 shapes of sphericity 0.3 to 0.9 and roundness 0.1 to 0.9"},
                {"error", which + " share of wrong pixels at 400 pixels across [-]"},
                {"time", "time to fit one grain [s]"},
                {"knob", "segments or sides; of a swarm, iterations (at 10 segments)"}};
    }

    std::vector<Silhouette> shapes_ = chartShapes();
    Results medians_;
    Results worst_;
};

Results measure()
{
    Sweep sweep;
    FitSettings settings;
    Sample direct{};
    for (const int segments : {3, 4, 5, 6, 8, 10, 14, 20})
    {
        settings.segments = segments;
        const Sample sample = sweep.add("direct", text("%d", segments), settings);
        direct = segments == comparedSegments ? sample : direct;
    }
    settings.joints = JointSpacing::equal;
    for (const int segments : {3, 4, 5, 6, 8, 10, 14, 20})
    {
        settings.segments = segments;
        sweep.add("direct, equal joints", text("%d", segments), settings);
    }

    settings.method = FitMethod::swarm;
    settings.segments = comparedSegments;
    double swarmBest = 1;
    for (const int particles : {5, 20, 50})
    {
        for (const int iterations : {5, 20, 50, 100})
        {
            settings.swarm.particles = particles;
            settings.swarm.iterations = iterations;
            const Sample sample = sweep.add(text("swarm of %d", particles), text("%d", iterations), settings);
            swarmBest = std::min(swarmBest, sample.medianError);
        }
    }

    settings.model = GrainModel::polygon;
    for (const int sides : {3, 5, 10, 20, 40})
    {
        settings.segments = sides;
        sweep.add("polygon", text("%d", sides), settings);
    }
    test::record("grainsFromImages", "directMilliseconds", direct.milliseconds, "ms");
    test::record("grainsFromImages", "directErrorOverSwarmBest", direct.medianError / swarmBest, "-");
    return sweep.results();
}

} // namespace

} // namespace chesil::benchmark

int main(int argumentCount, char** arguments)
{
    return chesil::benchmark::run(argumentCount, arguments, chesil::benchmark::measure);
}
